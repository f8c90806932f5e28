// The rule of gates (world/gate.hpp) in the continuous solver.

#include "custom/scenes.hpp"
#include "gate_checks.hpp"

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

// The bound on the speed of its surface, 5,000 m/s, asks for more than 100,000 steps to the end of the window.
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

}  // namespace
}  // namespace flipside::custom::test
