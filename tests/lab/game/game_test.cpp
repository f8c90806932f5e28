#include "lab/game/game.hpp"

#include "lab/game/game_rules.hpp"

namespace flipside::lab {
namespace {

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
