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

}  // namespace
}  // namespace flipside::custom::test
