#include "lab/game/game.hpp"

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
    rules.ball_search = 4;
    rules.lanes = {{{lane_a, lane_b}, 1000, true}};
    rules.skill_shot = {{lane_a, lane_b}, 700};
    rules.multiball = {3, 0.5, 4000};
    rules.end_bonus = {{{target_a, 200}, {target_b, 300}}, 3};
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
    explicit GameRules(Scene scene = scene_with_rules())
        : game(std::make_shared<const Scene>(std::move(scene))) {}

    Game game;
    double time = 0;
    std::vector<Ball> balls;

    /// Steps of 0.01 s at most, the events in the first one.
    std::vector<Control> see(std::vector<Event> events, double seconds = 0.01) {
        return game.observe(events, time += seconds, balls);
    }
    void enter(int count = 1) {
        for (int i = 0; i < count; ++i) {
            Ball ball;
            ball.radius = 0.01;
            ball.number = next++;
            balls.push_back(ball);
        }
    }
    void launch() {
        game.applied(control::Launch{}, time);
        enter();
        see({});
    }
    std::vector<Control> drain() {
        balls.pop_back();
        return see({lost()});
    }
    [[nodiscard]] const Caption& last() const { return game.captions().back(); }

  private:
    BallNumber next = 0;
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

TEST_F(GameRules, NudgesInQuickSuccessionTilt) {
    launch();
    for (const double at : {0.0, 1.0, 2.5}) game.applied(control::Nudge{}, at);
    EXPECT_FALSE(game.tilted());  // the first one is more than 2 s old
    EXPECT_EQ(last(), (Caption{CaptionKind::tilt_warning, 2.5}));
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

TEST_F(GameRules, ATiltIsNotWarnedOfWithFewerNudges) {
    launch();
    for (const double at : {0.0, 2.5, 5.0}) game.applied(control::Nudge{}, at);
    EXPECT_TRUE(game.captions().empty());
}

TEST_F(GameRules, ATiltForfeitsBallSaveAndBonus) {
    launch();
    see({hit(target_a)});
    for (const double at : {0.1, 0.2, 0.3}) game.applied(control::Nudge{}, at);
    const long score = game.score();
    drain();
    EXPECT_EQ(game.balls_left(), 1);
    EXPECT_EQ(game.score(), score);
    EXPECT_EQ(game.turns().number(), 2);
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

TEST_F(GameRules, TheEndBonusIsPaidOncePerLanesWhenTheBallIsLost) {
    launch();
    see({hit(target_a), hit(lane_a), hit(lane_b)});
    EXPECT_EQ(last(), (Caption{CaptionKind::lanes_complete, time, 1000, 2}));
    see({hit(target_a)});
    EXPECT_EQ(game.end_bonus(), 2 * 200);
    EXPECT_EQ(game.times(), 2);
    for (int i = 0; i < 3; ++i) see({hit(lane_a), hit(lane_b)});
    EXPECT_EQ(game.times(), 3);  // the most
    see({}, 6);
    const long score = game.score();
    drain();
    EXPECT_EQ(game.score(), score + 3 * 400);
    EXPECT_EQ(last(), (Caption{CaptionKind::bonus, time, 400, 3}));
    EXPECT_EQ(game.end_bonus(), 0);
    EXPECT_EQ(game.times(), 1);
}

TEST_F(GameRules, ASavedBallKeepsItsBonus) {
    launch();
    see({hit(target_a)});
    drain();
    EXPECT_EQ(game.end_bonus(), 200);
}

TEST_F(GameRules, AFlipperShiftsTheLightsOfLanesThatSaySo) {
    launch();
    see({hit(lane_a)});
    game.applied(control::Flip{Side::right, true}, time);
    EXPECT_FALSE(game.lit(lane_a));
    EXPECT_TRUE(game.lit(lane_b));
    game.applied(control::Flip{Side::right, false}, time);
    EXPECT_TRUE(game.lit(lane_b));
    game.applied(control::Flip{Side::left, true}, time);
    EXPECT_TRUE(game.lit(lane_a));
    game.applied(control::Flip{Side::left, true}, time);  // round the end
    EXPECT_TRUE(game.lit(lane_b));
    see({hit(lane_a)});
    EXPECT_EQ(last().kind, CaptionKind::lanes_complete);
}

TEST_F(GameRules, TheLastCaptionsAreKeptAndAllAreCounted) {
    launch();
    const std::size_t before = game.told();
    for (int i = 0; i < 20; ++i) see({hit(i % 2 == 0 ? lane_a : lane_b)});
    EXPECT_EQ(game.told(), before + 31);  // 1 skill shot, 20 lanes, 10 times all of them
    EXPECT_EQ(game.captions().size(), 8U);
    EXPECT_EQ(last().kind, CaptionKind::lanes_complete);
}

TEST_F(GameRules, TheSkillShotIsTheLitLaneAndNothingElseBefore) {
    EXPECT_EQ(game.skill_shot(), lane_a);
    launch();
    game.applied(control::Flip{Side::right, true}, time);
    EXPECT_EQ(game.skill_shot(), lane_b);
    game.applied(control::Flip{Side::right, true}, time);
    EXPECT_EQ(game.skill_shot(), lane_a);
    see({hit(lane_a)});
    EXPECT_EQ(game.score(), 5 + 700);
    EXPECT_EQ(game.skill_shot(), std::nullopt);
    see({}, 6);
    drain();
    launch();
    EXPECT_EQ(game.skill_shot(), lane_a);
    const long score = game.score();
    see({hit(bumper)});
    EXPECT_EQ(game.skill_shot(), std::nullopt);
    see({hit(lane_a)});
    EXPECT_EQ(game.score(), score + 100 + 5);
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

TEST_F(GameRules, ATargetThatIsDownInAStateCountsAsHit) {
    State state;
    state.parts.resize(6);
    state.parts[target_a].down = true;
    state.balls.resize(1);
    game.resume(state);
    balls.resize(1);
    EXPECT_EQ(see({hit(target_b)}).size(), 1U);
}

TEST(Game, WithoutRulesOnlyCountsBalls) {
    Scene scene;
    scene.balls.resize(2);
    Game game(std::make_shared<const Scene>(scene));
    EXPECT_TRUE(game.permits(control::Launch{}, scene.balls));
    EXPECT_TRUE(game.observe(std::vector{lost()}, 1, std::span(scene.balls).first(1)).empty());
    EXPECT_EQ(game.lost(), 1);
    EXPECT_EQ(game.launched(), 0);
    EXPECT_FALSE(game.over());
}

}  // namespace
}  // namespace flipside::lab
