#include "custom/geometry/inside.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "custom/geometry/bounds.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

double any(int limit) {
    return *rc::gen::inRange(-limit * 1000, limit * 1000) * 1e-3;
}

TEST(Inside, SolidsHoldTheirBordersAndNothingBeyond) {
    const Shape circle{shape::Circle{{1, 2}, 0.5}};
    EXPECT_TRUE(inside({1, 2}, circle));
    EXPECT_TRUE(inside({1.5, 2}, circle));
    EXPECT_FALSE(inside({1.5 + 1e-12, 2}, circle));
    const Shape triangle{shape::Polygon{{{0, 0}, {2, 0}, {0, 2}}}};
    EXPECT_TRUE(inside({1, 0}, triangle));
    EXPECT_TRUE(inside({0.9, 0.9}, triangle));
    EXPECT_FALSE(inside({1.1, 1.1}, triangle));
    const Shape capsule{shape::Capsule{{0, 0}, {2, 0}, 0.5}};
    EXPECT_TRUE(inside({2.4, 0}, capsule));
    EXPECT_TRUE(inside({1, -0.5}, capsule));
    EXPECT_FALSE(inside({2.4, 0.4}, capsule));
    const Shape flipper{shape::Flipper{{0, 0}, 2, 0.5, 0.25, std::numbers::pi / 2}};
    EXPECT_TRUE(inside({0, 2.2}, flipper));
    EXPECT_TRUE(inside({-0.45, 0}, flipper));
    EXPECT_FALSE(inside({0.4, 2}, flipper));
}

TEST(Inside, WhatIsThinContainsNothing) {
    EXPECT_FALSE(inside({1, 0}, {shape::Segment{{0, 0}, {2, 0}}}));
    EXPECT_FALSE(inside({0, 0}, {shape::Arc{{0, 0}, 1, 0, 6}}));
    EXPECT_FALSE(inside({0.5, 0.5}, {shape::Polyline{{{0, 0}, {2, 0}, {0, 2}}, true}}));
    EXPECT_FALSE(inside({0, 0}, {shape::Point{{0, 0}}}));
    EXPECT_FALSE(inside({1, 0}, {shape::Gate{{0, 0}, {2, 0}, {0, 1}}}));
}

TEST(Inside, CompoundsContainWhatAnyMemberDoes) {
    const Shape compound{
        shape::Compound{{{shape::Circle{{0, 0}, 1}},
                         {shape::Compound{{{shape::Circle{{5, 0}, 1}}, {shape::Segment{{0, 0}, {9, 0}}}}}}}}};
    EXPECT_TRUE(inside({0.5, 0}, compound));
    EXPECT_TRUE(inside({5.5, 0}, compound));
    EXPECT_FALSE(inside({2.5, 0}, compound));
}

/// A disc meets a box where the nearest point of the box, found by a search along its border, is in it.
RC_GTEST_PROP(Inside, DiscsOverlapBoxesAtTheirNearestPoint, ()) {
    const Box box{{-1, -0.5}, {any(2) + 2, any(1) + 1}};
    const Vec2 center{any(4), any(4)};
    const double radius = std::abs(any(2));
    const Shape solid{shape::Polygon{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
    bool near = inside(center, solid);
    const auto& corners = std::get<shape::Polygon>(solid.is).points;
    double nearest = 1e9;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 a = corners[i], side = corners[(i + 1) % 4] - a;
        RC_PRE(dot(side, side) > 0);
        const double along = std::clamp(dot(center - a, side) / dot(side, side), 0.0, 1.0);
        nearest = std::min(nearest, length(center - a - along * side));
    }
    RC_PRE(std::abs(nearest - radius) > 1e-9);
    near = near || nearest < radius;
    RC_ASSERT(overlap(box, center, radius) == near);
}

}  // namespace
}  // namespace flipside::custom
