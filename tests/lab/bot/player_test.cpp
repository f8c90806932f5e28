#include "lab/bot/player.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace flipside::lab::bot {
namespace {

/// A flipper that points right from the origin, and one that points left towards it, 0.02 m apart at their
/// tips; no gravity.
std::shared_ptr<const Scene> two_flippers() {
    Scene scene;
    scene.launcher.emplace();
    scene.launcher->position = {1, -1};
    scene.launcher->plunger = true;
    scene.rules.emplace();
    Part left, right;
    left.shape = {shape::Flipper{{0, 0}, 0.07, 0.01, 0.006, 0}};
    left.motion = motion::Flip{Side::left, 1, 20, 10};
    right.shape = {shape::Flipper{{0.19, 0}, 0.07, 0.01, 0.006, std::numbers::pi}};
    right.motion = motion::Flip{Side::right, std::numbers::pi - 1, 20, 10};
    scene.parts = {left, right};
    return std::make_shared<const Scene>(scene);
}

Ball falling_at(Vec2 place, double speed = 1) {
    Ball ball;
    ball.radius = 0.0135;
    ball.position = place;
    ball.velocity = {0, -speed};
    return ball;
}

/// What the player does while the ball falls, and when, s.
Script watched(std::uint64_t seed, Ball ball, double seconds = 1) {
    const auto scene = two_flippers();
    Player player(scene, seed);
    const Game game(scene);
    Script does;
    for (double time = 0; time < seconds; time += 1.0 / 60) {
        for (const Control& control : player.act(time, {&ball, 1}, game)) does.push_back({time, control});
        ball.position += (1.0 / 60) * ball.velocity;
    }
    return does;
}

TEST(BotPlayer, RaisesTheFlipperThatTheBallComesToAboutWhenItGetsThere) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Script does = watched(seed, falling_at({0.065, 0.5}));
        ASSERT_EQ(does.size(), 2U) << seed;
        const auto& raised = std::get<control::Flip>(does[0].control);
        EXPECT_TRUE(raised.up);
        EXPECT_EQ(raised.side, Side::left);
        EXPECT_NEAR(does[0].time, 0.46, 0.12);  // it touches the flipper after 0.476 s
        EXPECT_FALSE(std::get<control::Flip>(does[1].control).up);
        EXPECT_NEAR(does[1].time - does[0].time, 0.225, 0.1);
    }
}

TEST(BotPlayer, SeesNothingBeforeItsReactionTime) {
    // A ball that appears at the flipper is out of sight again before the player can act.
    const Script does = watched(1, falling_at({0.065, 0.03}, 3), 0.15);
    EXPECT_TRUE(does.empty());
}

TEST(BotPlayer, NudgesAtABallThatComesDownBetweenTheFlippersNowAndThen) {
    int nudges = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed)
        for (const TimedControl& timed : watched(seed, falling_at({0.1, 0.5}))) {
            const auto* nudge = std::get_if<control::Nudge>(&timed.control);
            ASSERT_NE(nudge, nullptr);
            EXPECT_NE(nudge->velocity.x, 0);
            ++nudges;
        }
    EXPECT_GT(nudges, 5);
    EXPECT_LT(nudges, 35);
}

TEST(BotPlayer, FiresABallThatWaits) {
    Ball waiting = falling_at({1, -1}, 0);
    const Script does = watched(1, waiting, 2);
    ASSERT_FALSE(does.empty());
    EXPECT_TRUE(std::holds_alternative<control::Launch>(does[0].control));
    EXPECT_GE(does[0].time, 0.5);
}

TEST(BotPlayer, TheSameSeedDoesTheSame) {
    const auto times = [](std::uint64_t seed) {
        std::vector<double> all;
        for (const TimedControl& timed : watched(seed, falling_at({0.065, 0.5}, 0.7)))
            all.push_back(timed.time);
        return all;
    };
    EXPECT_EQ(times(3), times(3));
    EXPECT_NE(times(3), times(5));
}

}  // namespace
}  // namespace flipside::lab::bot
