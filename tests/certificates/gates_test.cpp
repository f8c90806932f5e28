// Certificates of balls that pass a gate, also several at a time: an open gate lets every ball through.

#include <nlohmann/json.hpp>

#include "checking.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

using Json = nlohmann::json;

/// A gate along the x axis that opens to what comes from below.
Scene gate_scene(Vec2 gravity = {}) {
    Scene scene = empty_scene(gravity);
    add_part(scene, {shape::Gate{{-2, 0}, {2, 0}, {0, 1}}});
    return scene;
}

Json certified_gate(Scene scene) {
    const Engine& engine = lab::engine_named("reference");
    const auto shared = std::make_shared<const Scene>(std::move(scene));
    lab::Session session(shared, engine, lab::settings_for(engine, *shared, {}));
    return Json::parse(lab::certify(session, lab::Timeline(0, 1.5, lab::default_step), {}).json);
}

/// Ball 0 opens the gate from 0.4 s to 0.6 s.
Scene opened_from_below() {
    Scene scene = gate_scene();
    add_ball(scene, {-1, -0.5}, {0, 1}, 0.1);
    return scene;
}

void expect_accepted(const Json& run, std::size_t passages) {
    EXPECT_EQ(run["absences"].size(), passages);
    const Checked checked = check_certificate(run.dump());
    EXPECT_EQ(checked.code, 0) << checked.says;
}

TEST(GateCertificates, OfBallsThatPassOneAfterTheOtherAreAccepted) {
    Scene scene = opened_from_below();
    add_ball(scene, {1, -1}, {0, 1}, 0.1);
    expect_accepted(certified_gate(std::move(scene)), 2);
}

TEST(GateCertificates, OfBallsThatPassAtOverlappingTimesAreAccepted) {
    Scene scene = opened_from_below();
    add_ball(scene, {0, 0.65}, {0, -1}, 0.1);  // at the gate from 0.55 s to 0.75 s
    add_ball(scene, {1, 0.8}, {0, -1}, 0.1);   // from 0.7 s to 0.9 s
    expect_accepted(certified_gate(std::move(scene)), 3);
}

TEST(GateCertificates, OfABallThatPassesWhileAnotherComesAndLeavesAreAccepted) {
    Scene scene = opened_from_below();
    add_ball(scene, {1, -0.45}, {0, 10}, 0.1);
    scene.balls[1].velocity = {0, 0.9};
    add_ball(scene, {0, 4.6}, {0, -9}, 0.1);  // at the gate for 0.02 s
    expect_accepted(certified_gate(std::move(scene)), 3);
}

TEST(GateCertificates, OfABallThatLayOnAGateThatOpensAreAccepted) {
    Scene scene = gate_scene({0, -1});
    add_ball(scene, {1, 0.1}, {}, 0.1);
    add_ball(scene, {-1, -0.5}, {0, 2}, 0.1);
    expect_accepted(certified_gate(std::move(scene)), 2);
}

TEST(GateCertificates, OfABallThatPassesForTooLongAreRejected) {
    Scene scene = opened_from_below();
    add_ball(scene, {0, 0.65}, {0, -1}, 0.1);
    Json run = certified_gate(std::move(scene));
    run["absences"][0]["until"] = 0.65;
    EXPECT_NE(check_certificate(run.dump()).says.find("as long as it passes"), std::string::npos);
}

/// Two balls from above meet the closed gate at one instant, and a cheat lets both through.
TEST(GateCertificates, OfBallsThatOpenAGateForEachOtherAreRejected) {
    Scene scene = opened_from_below();
    add_ball(scene, {0, 0.5}, {0, -1}, 0.1);
    add_ball(scene, {1, 0.5}, {0, -1}, 0.1);
    Json run = certified_gate(std::move(scene));
    ASSERT_EQ(run["absences"].size(), 3U);
    expect_accepted(run, 3);
    ASSERT_EQ(run["absences"][0]["ball"], 0);
    run["balls"][0]["collides_with"] = 0;  // it meets no gate, and opens none
    run["absences"].erase(run["absences"].begin());
    const Checked checked = check_certificate(run.dump());
    EXPECT_EQ(checked.code, 1);
    EXPECT_NE(checked.says.find("from behind"), std::string::npos) << checked.says;
}

}  // namespace
}  // namespace flipside
