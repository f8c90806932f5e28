#include "lab/session/game.hpp"

#include <gtest/gtest.h>

namespace flipside::lab {
namespace {

constexpr PartIndex bumper = 0, lane_a = 1, lane_b = 2, target_a = 3, target_b = 4, spinner = 5;

Scene scene_with_rules() {
    Scene scene;
    scene.parts.resize(6);
    Launcher launcher;
    launcher.position = {1, 0};
    launcher.plunger = true;
    scene.launcher = launcher;
    Rules rules;
    rules.balls = 2;
    rules.ball_save = 5;
    rules.tilt_nudges = 3;
    rules.tilt_seconds = 2;
    rules.scores = {{bumper, 100}, {lane_a, 5}, {target_a, 20}};
    rules.lanes = {{{lane_a, lane_b}, 1000}};
    rules.targets = {{{target_a, target_b}, 500}};
    rules.spinners = {{spinner, 10, 8}};
    scene.rules = rules;
    return scene;
}

Event hit(PartIndex part, double speed = 1) {
    return {0, EventKind::impact, 0, Other::part(part), {}, {}, speed, 0};
}
Event lost() {
    return {0, EventKind::lost, 0, {}, {}, {}, 0, 0};
}

class GameRules : public ::testing::Test {
  protected:
    Game game{std::make_shared<const Scene>(scene_with_rules())};
    double time = 0;
    std::size_t balls = 0;

    std::vector<Control> see(std::vector<Event> events, double seconds = 0.01) {
        return game.observe(events, time += seconds, balls);
    }
    void launch() {
        game.applied(control::Launch{}, time);
        ++balls;
        see({});
    }
    void drain() {
        --balls;
        see({lost()});
    }
};

TEST_F(GameRules, PartsScoreTheirPoints) {
    launch();
    see({hit(bumper), hit(bumper), hit(lane_b)});
    EXPECT_EQ(game.score(), 200);
    see({{0, EventKind::sensor_begin, 0, Other::part(lane_a), {}, {}, 1, 0}});
    EXPECT_EQ(game.score(), 200 + 5 + 1000);
    see({{0, EventKind::begin, 0, Other::part(bumper), {}, {}, 1, 0},
         {0, EventKind::impact, 0, Other::ball(bumper), {}, {}, 1, 0}});
    EXPECT_EQ(game.score(), 1205);
}

TEST_F(GameRules, LanesStayLitUntilAllAre) {
    launch();
    see({hit(lane_a)});
    EXPECT_TRUE(game.lit(lane_a));
    EXPECT_FALSE(game.lit(lane_b));
    see({hit(lane_b)});
    EXPECT_FALSE(game.lit(lane_a));
    EXPECT_FALSE(game.lit(lane_b));
}

TEST_F(GameRules, ACompleteBankPaysOnceAndIsRaised) {
    launch();
    EXPECT_TRUE(see({hit(target_a)}).empty());
    const auto answer = see({hit(target_b)});
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_EQ(std::get<control::RaiseTargets>(answer[0]).parts, (std::vector<PartIndex>{target_a, target_b}));
    EXPECT_EQ(game.score(), 20 + 500);
    EXPECT_TRUE(see({}).empty());
    EXPECT_EQ(game.score(), 520);
}

TEST_F(GameRules, ASpinnerSlowsDownAndPaysEveryHalfTurn) {
    launch();
    see({hit(spinner, 2)}, 0);  // 16 half turns: rests after √16 / 2 = 2 s
    EXPECT_DOUBLE_EQ(game.spinning(spinner), 16);
    see({}, 1);  // (4 − 2)²
    EXPECT_DOUBLE_EQ(game.spinning(spinner), 4);
    EXPECT_EQ(game.score(), 120);
    see({}, 1.5);
    EXPECT_EQ(game.spinning(spinner), 0);
    EXPECT_EQ(game.score(), 160);
}

TEST_F(GameRules, ASavedBallIsGivenBackALateOneIsNot) {
    EXPECT_EQ(game.balls_left(), 2);
    launch();
    EXPECT_EQ(game.balls_left(), 1);
    drain();
    EXPECT_EQ(game.balls_left(), 2);
    launch();
    see({}, 6);
    drain();
    EXPECT_EQ(game.balls_left(), 1);
    EXPECT_FALSE(game.over());
    launch();
    see({}, 6);
    drain();
    EXPECT_TRUE(game.over());
    EXPECT_EQ(game.lost(), 3);
    EXPECT_EQ(game.launched(), 3);
    EXPECT_FALSE(game.permits(control::Launch{}, {}));
}

// Of 25 that a game of 2 balls has on the table, 2 are its own.
TEST_F(GameRules, SavingManyGivesBackNoMoreThanTheGameHas) {
    game.applied(control::Launch{1, 25, 1}, time);
    for (int i = 0; i < 25; ++i) {
        ++balls;
        see({});
    }
    EXPECT_EQ(game.balls_left(), 0);
    for (int i = 0; i < 25; ++i) drain();
    EXPECT_EQ(game.balls_left(), 2);
    EXPECT_EQ(game.launched(), 25);
    EXPECT_FALSE(game.over());
}

TEST_F(GameRules, OfManyThoseThatAreLostTooLateAreGone) {
    game.applied(control::Launch{1, 25, 1}, time);
    balls = 25;
    see({});
    drain();  // saved
    EXPECT_EQ(game.balls_left(), 1);
    see({}, 6);
    while (balls > 0) drain();
    EXPECT_EQ(game.balls_left(), 1);
    launch();
    drain();
    EXPECT_EQ(game.balls_left(), 1);
}

TEST_F(GameRules, LaunchesOnlyWhileEveryBallWaitsAtTheLauncher) {
    EXPECT_TRUE(game.permits(control::Launch{}, {}));
    launch();
    Ball ball;
    ball.radius = 0.1;
    ball.position = {1.05, 0};
    EXPECT_TRUE(game.permits(control::Launch{}, {&ball, 1}));
    ball.position = {1.15, 0};
    EXPECT_FALSE(game.permits(control::Launch{}, {&ball, 1}));
}

TEST_F(GameRules, NudgesInQuickSuccessionTilt) {
    launch();
    for (const double at : {0.0, 1.0, 2.5}) game.applied(control::Nudge{}, at);
    EXPECT_FALSE(game.tilted());  // the first one is more than 2 s old
    game.applied(control::Nudge{}, 2.9);
    EXPECT_TRUE(game.tilted());
    EXPECT_FALSE(game.permits(control::Flip{Side::left, true}, {}));
    EXPECT_TRUE(game.permits(control::Flip{Side::left, false}, {}));
    const auto answer = see({hit(bumper)});
    ASSERT_EQ(answer.size(), 2U);  // both flippers fall
    EXPECT_FALSE(std::get<control::Flip>(answer[0]).up);
    EXPECT_EQ(game.score(), 0);
    drain();
    EXPECT_FALSE(game.tilted());
}

TEST(Game, WithoutRulesOnlyCountsBalls) {
    Scene scene;
    scene.balls.resize(2);
    Game game(std::make_shared<const Scene>(scene));
    EXPECT_TRUE(game.permits(control::Launch{}, scene.balls));
    EXPECT_TRUE(game.observe(std::vector{lost()}, 1, 1).empty());
    EXPECT_EQ(game.lost(), 1);
    EXPECT_EQ(game.launched(), 0);
    EXPECT_FALSE(game.over());
}

}  // namespace
}  // namespace flipside::lab
