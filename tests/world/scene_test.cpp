#include "world/scene.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "world/events.hpp"

namespace flipside {
namespace {

TEST(Scene, MaterialsMixByProductGeometricMeanAndMaximum) {
    const Material a{"a", 0.8, 0.4, 0}, b{"b", 1.5, 0.1, 3};
    for (const Mixed& mixed : {mix(a, b), mix(b, a)}) {
        EXPECT_DOUBLE_EQ(mixed.restitution, 1.2);
        EXPECT_DOUBLE_EQ(mixed.friction, 0.2);
        EXPECT_EQ(mixed.kick, 3);
    }
}

TEST(Scene, LayersMeetOnlyWhenBothWantTo) {
    Ball ball;
    Part part;
    EXPECT_TRUE(layers_meet(ball, part));
    part.layer = 2;
    EXPECT_TRUE(layers_meet(ball, part));
    ball.collides_with = 1;
    EXPECT_FALSE(layers_meet(ball, part));
    ball.collides_with = 3;
    part.collides_with = 2;
    EXPECT_FALSE(layers_meet(ball, part));
    EXPECT_FALSE(layers_meet(part, ball));
}

TEST(Scene, InertiaIsThatOfADisc) {
    Ball ball;
    ball.radius = 0.2;
    ball.mass = 3;
    EXPECT_DOUBLE_EQ(inertia(ball), 0.06);
}

TEST(Scene, EventKindsHaveTheNamesOfTheFile) {
    EXPECT_EQ(name_of(EventKind::impact), "impact");
    EXPECT_EQ(name_of(EventKind::sensor_end), "sensor-end");
    EXPECT_EQ(name_of(EventKind::lost), "lost");
}

TEST(Vec2, CrossAndPerpTurnAnticlockwise) {
    EXPECT_EQ(perp(Vec2{1, 0}), (Vec2{0, 1}));
    EXPECT_EQ(cross(Vec2{1, 0}, Vec2{0, 1}), 1);
    EXPECT_EQ(cross(2.0, Vec2{3, 0}), (Vec2{0, 6}));  // ω × r
    EXPECT_NEAR(length(rotated({2, 0}, std::numbers::pi / 2) - Vec2{0, 2}), 0, 1e-15);
    EXPECT_DOUBLE_EQ(angle_of(from_angle(0.7)), 0.7);
}

TEST(Vec2, UnitOfNothingIsTheFallback) {
    EXPECT_EQ(unit({0, -5}), (Vec2{0, -1}));
    EXPECT_EQ(unit({0, 0}), (Vec2{0, 1}));
    EXPECT_EQ(unit({0, 0}, {1, 0}), (Vec2{1, 0}));
}

TEST(Box, IsClosed) {
    const Box box{{0, 0}, {1, 2}};
    EXPECT_TRUE(box.contains({1, 2}) && box.contains({0, 0}));
    EXPECT_FALSE(box.contains({1.0000001, 1}));
    EXPECT_FALSE(box.contains({std::nan(""), 1}));
}

}  // namespace
}  // namespace flipside
