#include "lab/game/turns.hpp"

#include "lab/game/game_rules.hpp"

namespace flipside::lab {
namespace {

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
        enter();
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
    enter(25);
    see({});
    drain();  // saved
    EXPECT_EQ(game.balls_left(), 1);
    see({}, 6);
    while (!balls.empty()) drain();
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

// A ball save mints nothing: what drains again after its time is lost, however often it was launched.
TEST_F(GameRules, ASavedBallHasNoNewBallSave) {
    launch();
    see({hit(bumper)}, 3);
    drain();
    EXPECT_EQ(last().kind, CaptionKind::ball_saved);
    EXPECT_EQ(game.balls_left(), 2);
    EXPECT_EQ(game.turns().number(), 1);
    launch();
    EXPECT_EQ(game.turns().number(), 1);
    see({}, 4);
    drain();
    EXPECT_EQ(game.balls_left(), 1);
    EXPECT_EQ(game.turns().number(), 2);
}

// A launch too weak to leave the lane costs nothing of the ball save.
TEST_F(GameRules, ABallThatHasNotScoredHasItsBallSaveFromItsLastLaunch) {
    launch();
    see({}, 4);
    game.applied(control::Launch{}, time);
    see({hit(bumper)}, 4);
    drain();
    EXPECT_EQ(game.balls_left(), 2);
}

TEST_F(GameRules, WithAllBanksDownTheTableBringsMoreBallsOneAtATime) {
    launch();
    see({hit(target_a)});
    auto answer = see({hit(target_b)});
    EXPECT_EQ(last(), (Caption{CaptionKind::multiball, time, 3}));
    ASSERT_EQ(answer.size(), 1U);  // the targets rise
    EXPECT_EQ(game.balls_left(), 1);
    for (int brought = 1; brought <= 2; ++brought) {
        EXPECT_TRUE(see({}, 0.9).empty());
        answer = see({}, 0.2);
        ASSERT_EQ(answer.size(), 1U);
        EXPECT_EQ(std::get<control::Launch>(answer[0]).strength, 0.5);
        enter();
        see({});
    }
    EXPECT_TRUE(see({}, 1.5).empty());
    EXPECT_EQ(game.balls_left(), 1);
    EXPECT_TRUE(game.turns().multiball());
    const long score = game.score();
    see({hit(target_a), hit(target_b)});
    EXPECT_EQ(game.score(), score + 20 + 500 + 4000);
    EXPECT_EQ(last(), (Caption{CaptionKind::jackpot, time, 4000}));

    // Within the ball save a ball that drains comes again by itself.
    answer = drain();
    EXPECT_EQ(last(), (Caption{CaptionKind::ball_saved, time, 0}));
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<control::Launch>(answer[0]));
    enter();
    see({}, 10);
    drain();
    drain();
    EXPECT_FALSE(game.turns().multiball());
    EXPECT_EQ(game.turns().number(), 1);
    drain();
    EXPECT_EQ(game.turns().number(), 2);
    EXPECT_EQ(game.balls_left(), 1);
    EXPECT_FALSE(game.over());
}

TEST_F(GameRules, ABallToComeKeepsTheTurn) {
    launch();
    see({hit(target_a), hit(target_b)}, 6);
    EXPECT_TRUE(game.turns().multiball());
    balls.clear();
    see({lost()}, 0.5);  // saved, for multiball has its own ball save
    EXPECT_EQ(game.turns().number(), 1);
    EXPECT_FALSE(game.permits(control::Launch{}, balls));
    const auto answer = see({}, 1);
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<control::Launch>(answer[0]));
}

TEST_F(GameRules, TheTableBringsNoBallWhileOneLiesAtTheLauncher) {
    launch();
    see({hit(target_a), hit(target_b)});
    balls.front().position = {1.01, 0};
    EXPECT_TRUE(see({}, 2).empty());
    balls.front().position = {0, 0};
    EXPECT_EQ(see({}).size(), 1U);
}

}  // namespace
}  // namespace flipside::lab
