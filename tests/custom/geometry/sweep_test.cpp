#include "custom/geometry/sweep.hpp"

#include <gtest/gtest.h>

#include "custom/geometry/narrow_phase.hpp"

namespace flipside::custom {
namespace {

/// First touch of a disc of radius 0.5 flying straight at a point in the origin.
double touch_of(Vec2 from, Vec2 velocity, double duration) {
    const auto separation = [&](double t) {
        return touch(from + t * velocity, 0.5, piece::Point{{0, 0}}).separation;
    };
    return first_touch(separation, length(velocity), duration, 1e-9);
}

TEST(Sweep, FindsTheTimeOfTouch) {
    EXPECT_NEAR(touch_of({-3, 0}, {2, 0}, 10), 1.25, 1e-9);
    EXPECT_NEAR(touch_of({-3, 0.3}, {2, 0}, 10), (3 - 0.4) / 2, 1e-8);
    EXPECT_NEAR(touch_of({-3, 0}, {2e6, 0}, 10), 1.25e-6, 1e-15);
}

TEST(Sweep, FindsNoneWhereThereIsNone) {
    EXPECT_EQ(touch_of({-3, 0}, {2, 0}, 1.24), never);
    EXPECT_EQ(touch_of({-3, 0}, {-2, 0}, 10), never);
    EXPECT_EQ(touch_of({-3, 0.51}, {2, 0}, 10), never);
}

TEST(Sweep, WhatTouchesAlreadyTouchesNow) {
    EXPECT_EQ(touch_of({-0.2, 0}, {2, 0}, 1), 0);
}

}  // namespace
}  // namespace flipside::custom
