#include "lab/bot/still_watch.hpp"

#include <gtest/gtest.h>

namespace flipside::lab::bot {
namespace {

std::shared_ptr<const Scene> table() {
    Scene scene;
    scene.launcher.emplace();
    scene.launcher->position = {5, 0};
    return std::make_shared<const Scene>(scene);
}

Ball ball_at(Vec2 place, BallNumber number = 0) {
    Ball ball;
    ball.radius = 0.1;
    ball.position = place;
    ball.number = number;
    return ball;
}

TEST(StillWatch, ABallThatStaysCountsOnceAfterTenSeconds) {
    StillWatch watch(table());
    const Ball ball = ball_at({1, 1});
    for (const double time : {0.0, 5.0, 9.9}) watch.look(time, {&ball, 1});
    EXPECT_EQ(watch.stuck(), 0);
    for (const double time : {10.0, 30.0}) watch.look(time, {&ball, 1});
    EXPECT_EQ(watch.stuck(), 1);
    EXPECT_EQ(watch.longest(), 30);
}

TEST(StillWatch, ABallThatShakesInItsPlaceIsStillAndOneThatLeavesItIsNot) {
    StillWatch shakes(table()), leaves(table());
    for (int i = 0; i <= 20; ++i) {
        const Ball shaking = ball_at({1 + 0.1 * (i % 2), 1}), leaving = ball_at({1 + 0.21 * (i / 6), 1});
        shakes.look(i, {&shaking, 1});
        leaves.look(i, {&leaving, 1});
    }
    EXPECT_EQ(shakes.stuck(), 1);
    EXPECT_EQ(leaves.stuck(), 0);
    EXPECT_EQ(leaves.longest(), 5);
}

TEST(StillWatch, WhatWaitsAtTheLauncherMayWait) {
    StillWatch watch(table());
    const Ball waiting = ball_at({5, 0.05});
    for (const double time : {0.0, 60.0}) watch.look(time, {&waiting, 1});
    EXPECT_EQ(watch.stuck(), 0);
    EXPECT_EQ(watch.longest(), 0);
}

TEST(StillWatch, EveryBallIsWatchedForItself) {
    StillWatch watch(table());
    const Ball first = ball_at({1, 1}), both[] = {first, ball_at({2, 2}, 1)};
    watch.look(0, {&first, 1});
    watch.look(9, both);
    watch.look(11, both);
    EXPECT_EQ(watch.stuck(), 1);
    watch.look(19, both);
    EXPECT_EQ(watch.stuck(), 2);
}

}  // namespace
}  // namespace flipside::lab::bot
