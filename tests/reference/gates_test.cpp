// The rule of gates on the exact engine.

#include "gate_checks.hpp"
#include "reference/support.hpp"

namespace flipside::reference::test {
namespace {

std::unique_ptr<World> exact(const Scene& scene) {
    return make_world(scene);
}

TEST(ReferenceGates, FollowTheRuleAtTheirEnds) {
    flipside::test::expect_the_rule(exact);
}
TEST(ReferenceGates, AreSolidToWhatSlidesRoundTheirEnd) {
    flipside::test::expect_to_slide_round_the_end(exact);
}
TEST(ReferenceGates, DecideOnceThoughSavedMeanwhile) {
    flipside::test::expect_the_decision_to_be_saved(exact);
}
TEST(ReferenceGates, PassEveryBallWhileOpen) {
    flipside::test::expect_an_open_gate_to_pass_all(exact);
}
TEST(ReferenceGates, LetGoOfWhatLiesOnThemWhenTheyOpen) {
    flipside::test::expect_an_opened_gate_to_let_go(exact);
}
TEST(ReferenceGates, AreLeftByABallThatIsLost) {
    flipside::test::expect_a_lost_ball_to_leave(exact);
}
TEST(ReferenceGates, DecideAboutWhatBeginsInThem) {
    flipside::test::expect_a_start_in_a_gate_to_be_decided(exact);
}

}  // namespace
}  // namespace flipside::reference::test
