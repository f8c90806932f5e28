#include "lab/game/ball_search.hpp"

#include "lab/game/game_rules.hpp"

namespace flipside::lab {
namespace {

TEST_F(GameRules, ABallThatMeetsNothingIsSought) {
    launch();
    balls.front().position = {0, 0};
    EXPECT_TRUE(see({}, 3.9).empty());
    EXPECT_EQ(game.searches(), 0);
    auto does = see({}, 0.2);
    ASSERT_EQ(does.size(), 2U);
    EXPECT_TRUE(std::get<control::Flip>(does[0]).up);
    EXPECT_EQ(last().kind, CaptionKind::ball_search);
    does = see({}, 0.2);
    ASSERT_EQ(does.size(), 2U);
    EXPECT_FALSE(std::get<control::Flip>(does[0]).up);
    double strength = 0;
    for (int i = 0; i < 100; ++i)
        for (const Control& control : see({}, 0.1))
            if (const auto* nudge = std::get_if<control::Nudge>(&control)) {
                EXPECT_GE(length(nudge->velocity), strength);
                strength = length(nudge->velocity);
            }
    EXPECT_GT(strength, 0.5);  // harder and harder
    EXPECT_EQ(game.searches(), 1);
    EXPECT_FALSE(game.tilted());
    see({hit(bumper)});
    EXPECT_TRUE(see({}, 3.9).empty());
}

TEST_F(GameRules, NoBallIsSoughtThatAHeldFlipperOrTheLauncherHolds) {
    launch();
    game.applied(control::Flip{Side::right, true}, time);
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(see({}, 1).empty());
    game.applied(control::Flip{Side::right, false}, time);
    balls.front().position = {1.01, 0};
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(see({}, 1).empty());
    EXPECT_EQ(game.searches(), 0);
}

// The tilt let the flipper fall, whatever the player's finger does.
TEST_F(GameRules, ABallIsSoughtAfterATiltThoughAKeyIsHeld) {
    launch();
    game.applied(control::Flip{Side::right, true}, time);
    for (const double at : {0.1, 0.2, 0.3}) game.applied(control::Nudge{}, at);
    see({}, 0.3);
    see({}, 4.1);
    EXPECT_EQ(game.searches(), 1);
}

}  // namespace
}  // namespace flipside::lab
