// Certificates of static heaps: what is accepted, and that no wrong contact force is.

#include <cmath>

#include <nlohmann/json.hpp>

#include "checking.hpp"
#include "heap_scenes.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

using HeapJson = nlohmann::json;

/// Balls in a groove of 60°, row by row, with a heavy one on top.
Scene groove(int rows, double friction) {
    Scene scene = heap_in_groove(rows, friction);
    add_ball(scene, {0, 0.2 + 0.2 * std::sqrt(0.75) * rows}, {}, 0.1, 50);
    scene.balls.back().position.x = rows % 2 == 0 ? 0 : 0.1;
    return scene;
}
Scene column(int balls) {
    Scene scene = empty_scene({0, -heap_gravity});
    add_part(scene, {shape::Segment{{-9, 0}, {9, 0}}});
    for (int i = 0; i < balls; ++i) add_ball(scene, {0, 0.1 + 0.2 * i}, {}, 0.1, i % 2 == 0 ? 1 : 1000);
    return scene;
}
HeapJson certified(Scene scene) {
    const Engine& engine = lab::engine_named("reference");
    const auto shared = std::make_shared<const Scene>(std::move(scene));
    lab::Session session(shared, engine, lab::settings_for(engine, *shared, {}));
    return HeapJson::parse(lab::certify(session, lab::Timeline(0, 0.5, lab::default_step), {}).json);
}

TEST(HeapCertificates, AreAccepted) {
    for (const Scene& scene : {column(2), column(10), groove(4, 0), groove(4, 0.5)}) {
        const HeapJson run = certified(scene);
        ASSERT_EQ(run["rests"].size(), 1U);
        EXPECT_GE(run["rests"][0]["forces"].size(), scene.balls.size());
        const Checked checked = check_certificate(run.dump());
        EXPECT_EQ(checked.code, 0) << checked.says;
        EXPECT_NE(checked.says.find(std::to_string(scene.balls.size()) + " at rest)"), std::string::npos)
            << checked.says;
    }
}

TEST(HeapCertificates, OfABallBetweenTwoPartsToo) {
    Scene scene = groove(0, 0.3);
    scene.balls[0].position = {0, 0.2};
    scene.balls[0].spin = 30;  // it is rubbed to rest
    const HeapJson run = certified(scene);
    ASSERT_EQ(run["rests"].size(), 2U);
    EXPECT_EQ(check_certificate(run.dump()).code, 0) << check_certificate(run.dump()).says;
    HeapJson other = run;
    other["rests"][0]["forces"][0]["friction"] = -run["rests"][0]["forces"][0]["friction"].get<double>();
    EXPECT_EQ(check_certificate(other.dump()).code, 1);
}

/// Each of the changes, made to the n-th force for every n, is rejected.
TEST(HeapCertificates, WithAnyWrongForceAreRejected) {
    const HeapJson run = certified(groove(3, 0.5));
    const std::size_t forces = run["rests"][0]["forces"].size();
    const auto rejected = [&](const auto& change) {
        for (std::size_t k = 0; k < forces; ++k) {
            HeapJson damaged = run;
            change(damaged["rests"][0]["forces"][k]);
            const Checked checked = check_certificate(damaged.dump());
            EXPECT_EQ(checked.code, 1) << "force " << k << ": " << checked.says;
        }
    };
    rejected([](HeapJson& force) { force["normal"] = force["normal"].get<double>() + 1e-4; });
    rejected([](HeapJson& force) { force["friction"] = force["friction"].get<double>() - 1e-4; });
    rejected([](HeapJson& force) { force["normal"] = -1e-3 - force["normal"].get<double>(); });
    rejected([](HeapJson& force) { force["ball"] = 99; });
}

TEST(HeapCertificates, WithOtherDamageAreRejected) {
    const HeapJson run = certified(groove(3, 0.5));
    const auto says = [&](const auto& change) {
        HeapJson damaged = run;
        change(damaged);
        const Checked checked = check_certificate(damaged.dump());
        return checked.code == 1 ? checked.says : "accepted: " + checked.says;
    };
    const auto expect = [](const std::string& said, const char* what) {
        EXPECT_NE(said.find(what), std::string::npos) << said;
    };
    expect(says([](HeapJson& r) { r["rests"] = HeapJson::array(); }), "flies by the equation of motion");
    expect(says([](HeapJson& r) { r["rests"][0]["until"] = 0.4; }), "rests as long as forces hold it");
    expect(says([](HeapJson& r) { r["balls"][1]["legs"][0]["velocity"] = {0, 1e-3}; }), "stays in contact");
    // Farther apart than what counts as touching, 2e-3 radii, and deeper than 1e-2.
    for (const double dy : {3e-4, -2e-3})
        expect(says([&](HeapJson& r) {
                   HeapJson& y = r["balls"].back()["legs"][0]["position"][1];
                   y = y.get<double>() + dy;
               }),
               "touches what it rests on");
    // Less friction than the forces need.
    expect(says([](HeapJson& r) {
               for (HeapJson& material : r["materials"]) material["friction"] = 1e-3;
           }),
           "friction within Coulomb's cone");
    expect(says([](HeapJson& r) { r["balls"][2]["mass"] = 1.001; }), "forces balance its weight");
    expect(says([](HeapJson& r) { r["gravity"] = {0.001, -heap_gravity}; }), "forces balance its weight");
}

/// No ball of a heap is in the way of a cheat: one that is at rest by forces from a ball that is not.
TEST(HeapCertificates, ForcesActOnBothSides) {
    HeapJson run = certified(column(2));
    HeapJson& forces = run["rests"][0]["forces"];
    // The lower ball no longer carries the upper one: the floor bears its own weight alone.
    for (HeapJson& force : forces)
        if (force["other"] == -1) force["normal"] = heap_gravity;
    EXPECT_EQ(check_certificate(run.dump()).code, 1);
    // Nor by a rest of its own beside that of the upper one.
    HeapJson own = certified(column(2));
    HeapJson rest = own["rests"][0];
    rest["forces"] = {
        {{"ball", 0}, {"other", -1}, {"feature", 0}, {"normal", heap_gravity}, {"friction", 0.0}}};
    own["rests"].insert(own["rests"].begin(), rest);
    const Checked checked = check_certificate(own.dump());
    EXPECT_EQ(checked.code, 1);
    EXPECT_NE(checked.says.find("forces balance its weight"), std::string::npos) << checked.says;
}

TEST(HeapCertificates, OnWhatCannotBeTouchedAreRejected) {
    HeapJson run = certified(column(2));
    run["parts"][0]["collides_with"] = 0;
    EXPECT_NE(check_certificate(run.dump()).says.find("can be touched"), std::string::npos);
    HeapJson layers = certified(column(2));
    layers["balls"][1]["collides_with"] = 0;
    EXPECT_NE(check_certificate(layers.dump()).says.find("can be touched"), std::string::npos);
}

}  // namespace
}  // namespace flipside
