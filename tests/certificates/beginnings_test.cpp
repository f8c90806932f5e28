// Certificates of balls that overlap a part where they begin, and are moved out of it.

#include <numbers>

#include <nlohmann/json.hpp>

#include "checking.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

using Json = nlohmann::json;

Json certified_beginning(Scene scene, const Script& script = {}) {
    const Engine& engine = lab::engine_named("reference");
    const auto shared = std::make_shared<const Scene>(std::move(scene));
    lab::Session session(shared, engine, lab::settings_for(engine, *shared, {}));
    return Json::parse(lab::certify(session, lab::Timeline(0, 0.5, lab::default_step), script).json);
}

void expect_accepted(const Json& run) {
    const Checked checked = check_certificate(run.dump());
    EXPECT_EQ(checked.code, 0) << checked.says;
}

void expect_discontinuous(const Json& run) {
    const Checked checked = check_certificate(run.dump());
    EXPECT_NE(checked.says.find("position is continuous"), std::string::npos) << checked.says;
}

TEST(BeginningCertificates, OfALaunchIntoAPartAreAccepted) {
    for (const double slope : {-90, 0, 90}) {
        Scene scene = empty_scene({0, -1});
        add_part(scene, segment({-1, 0}, {1, 0}));
        scene.launcher = {{0, 0.03}, from_angle(slope * std::numbers::pi / 180), 1, 1, false, {}};
        scene.launcher->ball.radius = 0.05;
        scene.launcher->ball.mass = 1;
        expect_accepted(certified_beginning(scene, {{0.1, control::Launch{}}}));
    }
}

TEST(BeginningCertificates, OfABallThatAGateBlocksAreAccepted) {
    for (const double speed : {-1.0, 0.0, 1.0}) {
        Scene scene = empty_scene({0, -1});
        add_part(scene, {shape::Gate{{-1, 0}, {1, 0}, {0, 1}}}, {"", 0.5, 0.2, 0});
        add_ball(scene, {0, 0.06}, {0.1, speed});
        expect_accepted(certified_beginning(scene));
    }
}

/// Ball 1 hits a target, into which ball 0 then sinks; at 0.2 s it overlaps it by 0.06.
Json with_a_raised_target() {
    Scene scene = empty_scene({0, -1});
    add_part(scene, {shape::Polygon{{{-1, 0}, {-1, -1}, {1, -1}, {1, 0}}}}).target = true;
    add_ball(scene, {0.5, 0.22}, {0, -0.8});
    add_ball(scene, {-0.5, 0.1}, {0, -1});
    return certified_beginning(scene, {{0.2, control::RaiseTargets{}}});
}

TEST(BeginningCertificates, OfABallThatARaisedTargetMovesAreAccepted) {
    expect_accepted(with_a_raised_target());
}

TEST(BeginningCertificates, OfABallThatIsMovedWithoutATargetAreRejected) {
    Json run = with_a_raised_target();
    for (Json& absence : run["absences"]) absence["until"] = 0.3;
    expect_discontinuous(run);
    run = with_a_raised_target();
    for (Json& leg : run["balls"][0]["legs"])
        if (leg["start"] > 0.19) leg["position"][1] = leg["position"][1].get<double>() + 0.01;
    expect_discontinuous(run);
}

}  // namespace
}  // namespace flipside
