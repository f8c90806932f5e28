/// What is heard of real games.

#include "app/sound/hearing.hpp"

#include <map>

#include <gtest/gtest.h>

#include "app/sound/samples.hpp"
#include "places.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::app::sound {
namespace {

Stage pinball(View view, const std::vector<std::string>& contenders = {}) {
    return {"pinball", "custom", view, {}, test::source("assets/scenes/pinball.script.json"), contenders};
}

/// Plays and hears so many seconds; what the mixer made of them.
Samples played(Stage& stage, double seconds, Hearing& hearing, Mixer& mixer, double speed = 1) {
    Samples all;
    for (const double end = stage.time() + seconds; stage.time() < end - 1e-9;) {
        const double from = stage.time();
        stage.step();
        hearing.hear(stage, from, from, speed, mixer);
        hearing.roll(stage, true, speed, mixer);
        const Samples part = rendered(mixer, stage.dt() / speed);
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

Samples played(Stage& stage, double seconds) {
    Hearing hearing;
    Mixer mixer;
    return played(stage, seconds, hearing, mixer);
}

TEST(Hearing, TenSecondsOfPinballAreTheSameSamplesTwice) {
    Stage one = pinball(View::split), other = pinball(View::split);
    const Samples samples = played(one, 10);
    EXPECT_EQ(samples, played(other, 10));
    EXPECT_GT(power_of(samples), 1000);
    EXPECT_GT(peak_of(samples), 3000);
    EXPECT_LE(peak_of(samples), ceiling);
}

struct Loudness {
    double rms = 0;
    double limited = 0;  ///< share of the hundredths of a second in which the limiter is at work
};

Loudness of_rain(const char* engine_name, int balls) {
    const Engine& engine = lab::engine_named(engine_name);
    const auto scene =
        std::make_shared<const Scene>(load_scene(test::source("assets/scenes/rain.json"), balls));
    Stage stage(scene, {{&engine, lab::settings_for(engine, *scene), engine_name, 1.0 / 60}}, View::single);
    const Samples samples = played(stage, 3);
    constexpr std::size_t hundredth = 2 * sample_rate / 100;
    Loudness loudness{std::sqrt(power_of(samples)), 0};
    for (std::size_t i = 0; i + hundredth <= samples.size(); i += hundredth)
        if (peak_of(std::span(samples).subspan(i, hundredth)) > 0.97 * ceiling) loudness.limited += 1.0 / 300;
    return loudness;
}

TEST(Hearing, AThousandRainingBallsAreLouderThanOneAndLeaveTheLimiterAlone) {
    for (const char* engine : {"custom", "box2d"}) {
        const Loudness one = of_rain(engine, 1), ten = of_rain(engine, 10), thousand = of_rain(engine, 1000);
        EXPECT_GT(ten.rms, 2 * one.rms) << engine;
        EXPECT_GT(thousand.rms, 1.5 * ten.rms) << engine;
        for (const Loudness& rain : {one, ten, thousand}) EXPECT_LE(rain.limited, 0.01) << engine;
    }
}

TEST(Hearing, SilenceWhereNothingHappens) {
    Stage stage("pinball", "custom", View::split, {}, {});
    EXPECT_EQ(peak_of(played(stage, 2)), 0);
}

TEST(Hearing, ThePanesAreHeardWhereTheyAre) {
    // The second pane has no ball.
    Stage stage("pinball", "custom", View::split, {}, {});
    stage.runs()[0].press(control::Launch{0.9});
    const Samples left = played(stage, 2);
    EXPECT_GT(power_of(left, 0), 1.5 * power_of(left, 1));
    stage.restart();
    stage.runs()[1].press(control::Launch{0.9});
    const Samples right = played(stage, 2);
    EXPECT_GT(power_of(right, 1), 1.5 * power_of(right, 0));
}

/// A session of the pinball table and what is heard of it.
struct Game {
    explicit Game(const std::string& engine_name = "custom", const Script& by = {})
        : scene(std::make_shared<const Scene>(load_scene(test::source("assets/scenes/pinball.json")))),
          engine(&lab::engine_named(engine_name)),
          session(scene, *engine, lab::settings_for(*engine, *scene, {})),
          script(by) {}

    void play(double seconds) {
        for (const double end = session.world().time() + seconds; session.world().time() < end - 1e-9;) {
            const double from = session.world().time();
            session.step(1.0 / 60, script, next);
            for (const Heard& one : ear.listen(session, session.events(), from)) {
                EXPECT_GE(one.time, from - 1e-9);
                EXPECT_LE(one.time, session.world().time() + 1e-9);
                heard.push_back(one);
            }
        }
    }
    [[nodiscard]] std::vector<Heard> of(Source source) const {
        std::vector<Heard> some;
        std::ranges::copy_if(heard, std::back_inserter(some),
                             [&](const Heard& one) { return one.strike.source == source; });
        return some;
    }

    std::shared_ptr<const Scene> scene;
    const Engine* engine;
    lab::Session session;
    Script script;
    std::size_t next = 0;
    Ear ear;
    std::vector<Heard> heard;
};

TEST(Ear, HearsEveryLaunchAndEveryWayOfAFlipper) {
    for (const char* engine : {"custom", "box2d", "reference"}) {
        Game game(engine, {{0.5, control::Launch{0.9}},
                           {0.7, control::Flip{Side::left, true}},
                           {1.2, control::Flip{Side::left, false}}});
        game.play(2);
        const auto launches = game.of(Source::launch);
        ASSERT_EQ(launches.size(), 1U) << engine;
        EXPECT_NEAR(launches[0].time, 0.5, 1.0 / 60 + 1e-9);
        EXPECT_NEAR(launches[0].strike.strength, 0.5 + 0.9 * 2.5, 0.1);
        EXPECT_GT(launches[0].strike.pan, 0.8) << "the plunger is at the right";
        const auto coils = game.of(Source::coil);
        ASSERT_EQ(coils.size(), 4U) << engine << ": off and at its stop, up and down";
        EXPECT_NEAR(coils[0].time, 0.7, 1.0 / 60);
        EXPECT_NEAR(coils[2].time, 1.2, 1.0 / 60);
        EXPECT_GT(coils[0].strike.strength, coils[3].strike.strength) << "down it goes slower";
        EXPECT_LT(coils[0].strike.pan, 0);
    }
}

TEST(Ear, HearsWhatABallHitsByItsSpeed) {
    Game game("custom", load_script(test::source("assets/scenes/pinball.script.json"), *Game().scene));
    game.play(20);
    std::map<Source, std::size_t> counts;
    for (const Heard& heard : game.heard) ++counts[heard.strike.source];
    for (const Source source : {Source::wall, Source::post, Source::bumper, Source::flipper, Source::target,
                                Source::rollover, Source::coil, Source::launch, Source::drain})
        EXPECT_GE(counts[source], 1U) << static_cast<int>(source);
    EXPECT_EQ(counts[Source::launch], 3U);
    EXPECT_EQ(counts[Source::drain], static_cast<std::size_t>(game.session.game().lost()));
    for (const Heard& bumped : game.of(Source::bumper))
        EXPECT_GE(bumped.strike.strength, 1.6) << "its coil kicks the ball away that fast at least";
}

TEST(Ear, HearsATiltOnce) {
    Script script{{0.5, control::Launch{0.9}}};
    for (const double time : {1.0, 1.1, 1.2, 1.3}) script.push_back({time, control::Nudge{{0.1, 0}}});
    Game game("custom", script);
    game.play(2);
    ASSERT_TRUE(game.session.game().tilted());
    const auto tilts = game.of(Source::tilt);
    ASSERT_EQ(tilts.size(), 1U);
    EXPECT_NEAR(tilts[0].time, 1.2, 2.0 / 60);
}

/// More balls on the table, all with that velocity, for a tenth of a second.
void roll(Game& game, std::initializer_list<Vec2> places, Vec2 velocity) {
    State state = game.session.world().save();
    for (const Vec2 place : places) {
        Ball ball = game.scene->launcher->ball;
        ball.number = state.next_number++;
        ball.position = place;
        ball.velocity = velocity;
        state.balls.push_back(ball);
    }
    game.session.restore(state);
    game.play(0.1);
}

TEST(Ear, HearsASlingshot) {
    Game game;
    game.play(0.1);
    roll(game, {{0.14, 0.31}}, {-1, 0});
    const auto hits = game.of(Source::slingshot);
    ASSERT_EQ(hits.size(), 1U);
    EXPECT_GT(hits[0].strike.strength, 1.4) << "it kicks the ball away that fast at least";
    EXPECT_LT(hits[0].strike.pan, 0);
}

TEST(Ear, HearsWhatPaysABonusOnceInAStep) {
    constexpr Vec2 lane_a{0.194, 0.925}, lane_b{0.242, 0.925}, lane_c{0.29, 0.925}, down{0, -1};
    Game game;
    game.play(0.1);
    EXPECT_TRUE(game.heard.empty());
    roll(game, {lane_a}, down);
    EXPECT_EQ(game.session.game().score(), 50 + 2500);  // the skill shot
    ASSERT_EQ(game.of(Source::bonus).size(), 1U);
    EXPECT_NEAR(game.of(Source::bonus)[0].time, game.of(Source::rollover)[0].time, 1.0 / 60);
    roll(game, {lane_b, lane_c}, down);
    EXPECT_GE(game.session.game().score(), 3 * 50 + 2500 + 1000);  // all lanes, and a bumper
    EXPECT_EQ(game.of(Source::bonus).size(), 2U);
    Game both;
    both.play(0.1);
    roll(both, {lane_a, lane_b, lane_c}, down);
    EXPECT_EQ(both.session.game().score(), 3 * 50 + 2500 + 1000);
    EXPECT_EQ(both.of(Source::bonus).size(), 1U);
}

TEST(Ear, WhatIsPutIntoAnotherStateMakesNoSoundByItself) {
    Game game("custom", {{0.5, control::Launch{0.9}}, {0.6, control::Flip{Side::left, true}}});
    game.play(0.55);
    const State early = game.session.world().save();
    game.play(0.45);
    game.heard.clear();
    const State late = game.session.world().save();
    game.session.restore(early);
    game.next = game.script.size();
    game.play(1.0 / 60);
    game.session.restore(late);
    game.play(1.0 / 60);
    EXPECT_TRUE(game.of(Source::launch).empty());
    EXPECT_TRUE(game.of(Source::coil).empty());
}

TEST(Ear, HearsRollingOnATableAndInABowlButNoFlight) {
    Game game("custom", {{0.1, control::Launch{0.9}}});
    EXPECT_EQ(game.ear.roll(game.session).speed, 0);
    game.play(0.3);
    EXPECT_NEAR(game.ear.roll(game.session).speed, length(game.session.world().balls()[0].velocity), 1e-12);
    EXPECT_GT(game.ear.roll(game.session).pan, 0.8);
    // Upright scenes: falling makes no sound.
    Stage stage("drop", "custom", View::single, {}, {});
    Ear ear;
    stage.run_until(0.1);
    ear.listen(stage.runs()[0].session(), {}, 0);
    EXPECT_GT(length(stage.runs()[0].session().world().balls()[0].velocity), 0.5);
    EXPECT_EQ(ear.roll(stage.runs()[0].session()).speed, 0);
}

TEST(Hearing, SlowMotionSoundsLowerAnOctaveAtASixteenth) {
    const auto launch = [](double speed) {
        Stage stage("pinball", "custom", View::single, {}, {});
        Hearing hearing;
        Mixer mixer;
        stage.step();
        hearing.hear(stage, 0, 0, speed, mixer);
        stage.press(control::Launch{1});
        const double from = stage.time();
        stage.step();
        hearing.hear(stage, from, from, speed, mixer);
        return rendered(mixer, 1);
    };
    // The modes of the plunger's rod.
    const Samples usual = launch(1), slow = launch(1.0 / 16);
    EXPECT_GT(strength_at(usual, 530), 4 * strength_at(usual, 265));
    EXPECT_GT(strength_at(slow, 265), 4 * strength_at(slow, 530));
}

}  // namespace
}  // namespace flipside::app::sound
