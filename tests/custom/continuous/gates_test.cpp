// The rule of gates (world/gate.hpp) in the continuous solver.

#include "custom/scenes.hpp"
#include "gate_checks.hpp"
#include "world/state_file.hpp"

namespace flipside::custom::test {
namespace {

std::unique_ptr<World> sleepless(const Scene& scene) {
    return make_world(scene, {{"solver", "continuous"}, {"sleep", "off"}});
}

TEST(Gates, FollowTheRuleAtTheirEnds) {
    flipside::test::expect_the_rule(sleepless);
}
TEST(Gates, AreSolidToABallThatSlidesAroundTheirEnd) {
    flipside::test::expect_to_slide_round_the_end(sleepless);
}
TEST(Gates, DecideOnceAlsoAcrossASavedState) {
    flipside::test::expect_the_decision_to_be_saved(sleepless);
}
TEST(Gates, PassEveryBallWhileOpen) {
    flipside::test::expect_an_open_gate_to_pass_all(sleepless);
}
TEST(Gates, ReleaseRestingBallsWhenTheyOpen) {
    flipside::test::expect_an_opened_gate_to_let_go(sleepless);
}
TEST(Gates, CloseWhenTheBallInThemIsLost) {
    flipside::test::expect_a_lost_ball_to_leave(sleepless);
}
TEST(Gates, DecideForBallsThatStartInThem) {
    flipside::test::expect_a_start_in_a_gate_to_be_decided(sleepless);
}

// The bound on the speed of its surface, 5,000 m/s, asks for more than 100,000 steps to the end of the
// window.
TEST(Sensors, ThatTurnFastAreStillEntered) {
    Scene scene = empty_scene({0, -9.81});
    add_part(scene, segment({-1, 0}, {1, 0}));
    Part& disc = add_part(scene, {shape::Circle{{0.1, 1.0302}, 1}});
    disc.sensor = true;
    disc.motion = motion::Turn{{0.1, 1.0302}, 5000, true};
    add_ball(scene, {0.1, 0.01}, {}, 0.01);
    const auto world = sleepless(scene);
    const auto entered = [&] {
        return std::ranges::any_of(world->events(),
                                   [](const Event& e) { return e.kind == EventKind::sensor_begin; });
    };
    for (int step = 0; step < 30; ++step) {
        world->step(1.0 / 60);
        EXPECT_FALSE(entered());
    }
    world->apply(control::Nudge{{0, 1}});
    world->step(1.0 / 60);
    EXPECT_TRUE(entered());
}

TEST(Sensors, AreRememberedWhileAllSleep) {
    Scene scene = empty_scene({0, -9.81});
    add_part(scene, segment({-1, 0}, {1, 0}));
    add_part(scene, segment({-0.5, 0}, {0.5, 0})).sensor = true;
    add_ball(scene, {0, 0.1});
    const auto world = make_world(scene, {{"solver", "continuous"}});
    for (int step = 0; step < 60; ++step) {
        world->step(1.0 / 60);
        EXPECT_EQ(world->save().memory.inside.size(), 1U) << step;
    }
    EXPECT_TRUE(world->balls()[0].asleep);
}

/// A ball that rolls along a slope, with a sensor flush with its surface: between 1 and 3 m of the way the
/// ball is inside the sensor to rounding.
Scene slope_with_flush_sensor(double angle) {
    Scene scene = empty_scene({0, -9.81});
    const Vec2 origin{0.3, -0.7};
    const auto at = [&](double along, double above) { return origin + rotated({along, above}, angle); };
    add_part(scene, segment(at(-1, 0), at(6, 0)), {"", 0.3, 0.2, 0});
    add_part(scene, segment(at(1, 0), at(3, 0))).sensor = true;
    add_ball(scene, at(0, 0.1), rotated({1.3, 0}, angle), 0.1);
    return scene;
}

/// Kinds and times of the events with sensors in the steps that a world makes up to 3 s.
std::vector<std::pair<EventKind, double>> sensed_until_the_end(World& world) {
    std::vector<std::pair<EventKind, double>> all;
    while (world.time() < 3) {
        world.step(1.0 / 60);
        for (const Event& e : world.events())
            if (e.kind == EventKind::sensor_begin || e.kind == EventKind::sensor_end)
                all.emplace_back(e.kind, e.time);
    }
    return all;
}

TEST(Sensors, ThatAreFlushWithASurfaceAreEnteredAndLeftOnceAlsoAcrossASavedState) {
    for (int i = 0; i < 20; ++i) {
        const Scene scene = slope_with_flush_sensor(-0.01 - 0.025 * i);
        const auto expected = sensed_until_the_end(*sleepless(scene));
        ASSERT_EQ(expected.size(), 2U) << i;
        EXPECT_EQ(expected[0].first, EventKind::sensor_begin);
        EXPECT_EQ(expected[1].first, EventKind::sensor_end);
        const auto world = sleepless(scene);
        while (world->time() < expected[0].second + 0.02) world->step(1.0 / 60);
        for (; world->time() < expected[1].second - 0.04; world->step(1.0 / 60)) {
            const auto restored = sleepless(scene);
            restored->restore(parse_state(to_json(world->save(), scene), "state.json", scene));
            const auto rest = sensed_until_the_end(*restored);
            ASSERT_EQ(rest.size(), 1U) << i << " at " << world->time();
            EXPECT_EQ(rest[0], expected[1]);
        }
    }
}

}  // namespace
}  // namespace flipside::custom::test
