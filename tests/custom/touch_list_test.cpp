#include "custom/touch_list.hpp"

#include <gtest/gtest.h>

#include "custom/broad_phase/registry.hpp"
#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

/// Sleeping balls of 0.1 m on a floor: three in a row, one on the first two.
class TouchListTest : public ::testing::Test {
  protected:
    TouchListTest() {
        Scene scene = empty_scene({0, -9.81});
        for (const double x : {0.0, 0.2, 0.4}) add_ball(scene, {x, 0.1});
        add_ball(scene, {0.1, 0.1 + 0.2 * std::sqrt(0.75)});
        add_part(scene, segment({-1, 0}, {1, 0}));
        for (Ball& ball : scene.balls) ball.asleep = true;
        scene_ = std::make_shared<const Scene>(scene);
        balls_ = scene.balls;
    }

    /// Which balls are awake after `index` has been moved and no longer sleeps.
    std::vector<bool> awake_after(std::size_t index, Vec2 by) {
        const Table table(scene_);
        const Layout layout(*scene_);
        const auto broad = make_broad_phase(*scene_, layout.still_proxies(), Settings(engine().settings));
        TouchList touches(layout, table, *broad, sleep_distance);
        touches.reserve(balls_.size());
        touches.search(balls_);
        balls_[index].position += by;
        balls_[index].asleep = false;
        touches.search(balls_);
        touches.wake_unsupported(balls_);
        std::vector<bool> awake;
        for (const Ball& ball : balls_) awake.push_back(!ball.asleep);
        return awake;
    }

    /// Which balls are awake, of those that nothing holds.
    std::vector<bool> unheld(const std::vector<Vec2>& shifts) {
        const Table table(scene_);
        const Layout layout(*scene_);
        const auto broad = make_broad_phase(*scene_, layout.still_proxies(), Settings(engine().settings));
        for (std::size_t i = 0; i < shifts.size(); ++i) balls_[i].position += shifts[i];
        TouchList touches(layout, table, *broad, sleep_distance);
        touches.search(balls_);
        touches.wake_unheld(balls_);
        std::vector<bool> awake;
        for (const Ball& ball : balls_) awake.push_back(!ball.asleep);
        return awake;
    }

    std::shared_ptr<const Scene> scene_;
    std::vector<Ball> balls_;
};

TEST_F(TouchListTest, ASupportLostAtTheSideWakesAllThatTouch) {
    EXPECT_EQ(awake_after(2, {0.001, 0}), (std::vector{true, true, true, true}));
}

// Members of an island hop by this much between ticks. A heap beside them could never sleep.
TEST_F(TouchListTest, ASupportThatHopsStaysASupport) {
    EXPECT_EQ(awake_after(2, {0.0002, 0}), (std::vector{false, false, true, false}));
}

TEST_F(TouchListTest, WhatLeavesFromAboveWakesNone) {
    EXPECT_EQ(awake_after(3, {0, 0.1}), (std::vector{false, false, false, true}));
}

TEST_F(TouchListTest, WhatAFloorHoldsSleeps) {
    EXPECT_EQ(unheld({}), (std::vector{false, false, false, false}));
}

TEST_F(TouchListTest, WhatNothingHoldsWakes) {
    EXPECT_EQ(unheld({{}, {}, {}, {0, 0.01}}), (std::vector{false, false, false, true}));
}

TEST_F(TouchListTest, BallsInTheAirDoNotHoldEachOther) {
    EXPECT_EQ(unheld({{0, 1}, {0, 1}, {}, {0, 1}}), (std::vector{true, true, false, true}));
}

TEST_F(TouchListTest, AnAwakeBallHolds) {
    balls_[0].asleep = balls_[1].asleep = false;
    EXPECT_EQ(unheld({{0, 1}, {0, 1}, {0, 2}, {0, 1}}), (std::vector{true, true, true, false}));
}

}  // namespace
}  // namespace flipside::custom::test
