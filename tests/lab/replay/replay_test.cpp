#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/process/failure.hpp"
#include "lab/replay/play.hpp"
#include "lab/scenes/dice.hpp"
#include "lab/session/ball_edit.hpp"
#include "lab/session/recorder.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

std::shared_ptr<const Scene> pinball_table() {
    return std::make_shared<const Scene>(load_scene(scene_file("pinball")));
}

Session new_game(const std::string& engine) {
    const auto scene = pinball_table();
    const Engine& named = engine_named(engine);
    return {scene, named, settings_for(named, *scene)};
}

/// A player without a plan: flips, launches when that may be, nudges now and then.
void play_blindly(Session& session, Dice& dice, std::uint64_t steps, double dt = 1.0 / 60) {
    for (std::uint64_t k = 0; k < steps; ++k) {
        const double toss = dice.between(0, 1);
        const Side side = dice.between(0, 1) < 0.5 ? Side::left : Side::right;
        if (toss < 0.15)
            static_cast<void>(session.press(control::Flip{side, dice.between(0, 1) < 0.5}));
        else if (toss < 0.17)
            static_cast<void>(session.press(control::Launch{dice.between(0.3, 1)}));
        else if (toss < 0.172)
            static_cast<void>(session.press(control::Nudge{{dice.between(-0.2, 0.2), 0.1}}));
        session.step(dt);
        // The game is over too soon for ten minutes: the next balls come by hand.
        if (!session.world().balls().empty() || !session.game().over()) continue;
        edit::Add add{session.scene().launcher->ball};
        add.ball.position = {dice.between(0.1, 0.4), dice.between(0.3, 0.9)};
        add.ball.velocity = dice.direction();
        if (const auto state = edited(session.scene(), session.world().save(), add))
            session.edit(add, *state);
    }
}

Replay saved(const Session& session, double dt = 1.0 / 60) {
    const RecordedRun run{"game", &session, dt};
    return parse_replay(to_json(replay_of({&run, 1})), "game.flipside-replay");
}

/// Plays all of it; the parting, if there is one.
std::optional<ReplayParting> parting_of(const Replay& replay) {
    ReplayPlayer player(replay, 0);
    while (player.step()) {
    }
    return player.parting();
}

class ReplayOn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Engines, ReplayOn, testing::Values("custom", "box2d"));

TEST_P(ReplayOn, TenMinutesOfAGameReplayToTheBit) {
    Session game = new_game(GetParam());
    Dice dice(7);
    play_blindly(game, dice, 36'000);
    EXPECT_GT(game.totals().impacts, 1000U);
    const Replay replay = saved(game);
    EXPECT_EQ(replay.runs[0].steps, 36'000U);
    EXPECT_EQ(replay.runs[0].checks.size(), 60U);
    ReplayPlayer player(replay, 0);
    while (player.step()) {
    }
    EXPECT_FALSE(player.parting());
    EXPECT_EQ(player.session().game().score(), game.game().score());
    EXPECT_EQ(player.session().world().save().balls, game.world().save().balls);
}

TEST_P(ReplayOn, WhatIsChangedInAGameIsInItsReplay) {
    Session game = new_game(GetParam());
    Dice dice(11);
    play_blindly(game, dice, 700);
    game.apply(control::Launch{0.9, 3, 1});
    play_blindly(game, dice, 300);
    const Engine& other = engine_named(std::string(GetParam()) == "custom" ? "box2d" : "custom");
    game.change(game.shared_scene(), other, settings_for(other, game.scene()));
    play_blindly(game, dice, 200);
    game.change(with_gravity(game.shared_scene(), {}), other, game.settings());
    play_blindly(game, dice, 200, 1.0 / 240);
    game.resume();
    play_blindly(game, dice, 200, 1.0 / 240);
    const BallNumber number = game.world().balls().empty() ? 0 : game.world().balls().front().number;
    for (const BallEdit& edit : {BallEdit{edit::Throw{number, {0.5, 1}}}, BallEdit{edit::Remove{number + 1}}})
        if (const auto state = edited(game.scene(), game.world().save(), edit)) game.edit(edit, *state);
    play_blindly(game, dice, 300);
    game.clear();
    play_blindly(game, dice, 200);
    EXPECT_EQ(parting_of(saved(game)), std::nullopt);
}

TEST_P(ReplayOn, AScriptAndPressesAtOneTimeKeepTheirOrder) {
    Session game = new_game(GetParam());
    const Script script{{0.0137, control::Launch{0.8}},
                        {1, control::Nudge{{0.05, 0.1}}},
                        {1.777, control::Flip{Side::left, true}}};
    std::size_t next = 0;
    for (int k = 0; k < 900; ++k) {
        if (k % 60 == 0) game.apply(control::Flip{Side::right, k % 120 == 0});
        game.step(1.0 / 60, script, next);
    }
    const Replay replay = saved(game);
    EXPECT_EQ(replay.runs[0].script.size(), 3U);
    EXPECT_EQ(parting_of(replay), std::nullopt);
}

TEST_P(ReplayOn, AfterGoingBackTheReplayIsOfTheCourseInForce) {
    Session game = new_game(GetParam());
    Recorder recorder;
    recorder.start(game, 0);
    const auto play = [&](int steps, bool flips) {
        for (int k = 0; k < steps; ++k) {
            std::vector<Control> pressed;
            if (k == 0 || (flips && k % 20 == 0)) {
                pressed.emplace_back(k == 0 ? Control{control::Launch{0.9}}
                                            : Control{control::Flip{Side::left, k % 40 == 0}});
                game.apply(pressed.back());
            }
            game.step(1.0 / 60);
            recorder.record(game, {1.0 / 60, 1.0 / 60, pressed}, game.events(), 0);
        }
    };
    play(400, false);
    const std::size_t then = recorder.at(3.005);
    static_cast<void>(recorder.restore(then, game, {}));
    recorder.forget_after(then);
    play(500, true);
    const Replay replay = saved(game);
    EXPECT_EQ(replay.runs[0].steps, then + 500);
    EXPECT_EQ(parting_of(replay), std::nullopt);
}

/// Box2D goes on from a saved heap in another way: its contacts begin without their impulses.
TEST_P(ReplayOn, AHeapThatWasGoneBackToReplaysToTheBit) {
    const auto scene = std::make_shared<const Scene>(load_scene(scene_file("bowl")));
    const Engine& engine = engine_named(GetParam());
    Session game(scene, engine, settings_for(engine, *scene));
    Recorder recorder;
    recorder.start(game, 0);
    const auto play = [&](int steps) {
        for (int k = 0; k < steps; ++k) {
            game.step(1.0 / 60);
            recorder.record(game, {1.0 / 60, 1.0 / 60, {}}, game.events(), 0);
        }
    };
    play(90);
    const std::size_t then = recorder.at(1);
    static_cast<void>(recorder.restore(then, game, {}));
    recorder.forget_after(then);
    play(60);
    EXPECT_EQ(parting_of(saved(game)), std::nullopt);
    game.resume();
    play(60);
    EXPECT_EQ(parting_of(saved(game)), std::nullopt);
}

TEST(Replay, PlaysOnAnotherEngineWithTheSameHands) {
    Session game = new_game("custom");
    Dice dice(3);
    play_blindly(game, dice, 1200);
    const Replay replay = saved(game);
    ReplayPlayer other(replay, 0, engine_named("box2d"));
    while (other.step()) {
    }
    EXPECT_EQ(other.session().engine().name, "box2d");
    EXPECT_NEAR(other.session().world().time(), 20, 1e-9);
    EXPECT_GT(other.session().totals().launched, 0U);
    EXPECT_FALSE(other.parting());
}

TEST(Replay, SaysBetweenWhichTimesItParted) {
    Session game = new_game("custom");
    Dice dice(3);
    play_blindly(game, dice, 1500);
    Replay replay = saved(game);
    // A launch that was not.
    replay.runs[0].moves.insert(replay.runs[0].moves.begin(), {0, move::Press{0, control::Nudge{{0, 3}}}});
    for (auto& entry : replay.runs[0].moves)
        if (auto* press = std::get_if<move::Press>(&entry.move); press && entry.step > 700)
            press->control = control::Nudge{{1, 1}};
    const auto parting = parting_of(replay);
    ASSERT_TRUE(parting);
    EXPECT_NEAR(parting->after, 10, 1e-9);
    EXPECT_NEAR(parting->before, 20, 1e-9);
    Replay wrong_end = saved(game);
    wrong_end.runs[0].end.checksum ^= 1;
    const auto at_end = parting_of(wrong_end);
    ASSERT_TRUE(at_end);
    EXPECT_NEAR(at_end->after, 20, 1e-9);
    EXPECT_NEAR(at_end->before, 25, 1e-9);
    Replay wrong_score = saved(game);
    ++wrong_score.runs[0].end.score;
    EXPECT_TRUE(parting_of(wrong_score));
    Replay wrong_time = saved(game);
    wrong_time.runs[0].end.time += 1;
    EXPECT_TRUE(parting_of(wrong_time));
}

TEST(Replay, SaysWhyAGameCannotBeSaved) {
    const auto why = [](const Session& session) -> std::string {
        const RecordedRun run{"game", &session, 1.0 / 60};
        try {
            static_cast<void>(replay_of({&run, 1}));
        } catch (const Failure& failure) {
            return failure.what();
        }
        return "";
    };
    Session restored = new_game("custom");
    restored.restore(restored.world().save());
    EXPECT_NE(why(restored).find("does not come from the scene"), std::string::npos);

    Scene made = *pinball_table();
    made.document.reset();
    const Engine& custom = engine_named("custom");
    EXPECT_NE(
        why(Session(std::make_shared<const Scene>(made), custom, Settings(custom.settings))).find("no file"),
        std::string::npos);
    Scene changed = *pinball_table();
    changed.damping += 1;
    EXPECT_NE(why(Session(std::make_shared<const Scene>(changed), custom, Settings(custom.settings)))
                  .find("not as in its file"),
              std::string::npos);
    EXPECT_EQ(why(new_game("custom")), "");
}

}  // namespace
}  // namespace flipside::lab
