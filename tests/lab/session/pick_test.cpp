#include "lab/session/pick.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "world/scene_builder.hpp"

namespace flipside::lab {
namespace {

class Pick : public testing::Test {
  protected:
    Pick() {
        add_ball(scene, {0, 0}, {}, 0.5);
        add_ball(scene, {3, 0}, {}, 0.5);
        add_part(scene, segment({-5, -1}, {5, -1}));
        add_part(scene, {shape::Circle{{0, 4}, 1}});
        add_part(scene, {shape::Segment{{6, 0}, {8, 0}}}).motion = motion::Turn{{6, 0}, 1, true};
        parts.resize(scene.parts.size());
    }
    [[nodiscard]] std::optional<Other> at(Vec2 point, double reach = 0.1) const {
        return pick(scene, scene.balls, parts, point, reach);
    }
    [[nodiscard]] bool free(Vec2 place, double radius = 0.5) const {
        Ball ball = scene.balls[0];
        ball.position = place;
        ball.radius = radius;
        return is_free(scene, scene.balls, parts, ball);
    }

    Scene scene = empty_scene();
    std::vector<PartState> parts;
};

TEST_F(Pick, TheBallThatIsThereBeforeThePartThatIsNear) {
    EXPECT_EQ(at({0.4, 0}), Other::ball(0));
    EXPECT_EQ(at({3.4, 0.2}), Other::ball(1));
    EXPECT_EQ(at({0, -0.55}), Other::ball(0));
    EXPECT_EQ(at({0, -0.65}), std::nullopt);
    EXPECT_EQ(at({0, -0.95}), Other::part(0));
    EXPECT_EQ(at({0, -0.52}, 0.6), Other::ball(0));
}

TEST_F(Pick, TheInsideOfWhatHasOne) {
    EXPECT_EQ(at({0.3, 4.2}), Other::part(1));
    EXPECT_EQ(at({0, 5.05}), Other::part(1));
    EXPECT_EQ(at({0, 5.2}), std::nullopt);
}

TEST_F(Pick, PartsAreWhereTheyHaveTurned) {
    EXPECT_EQ(at({8, 0}), Other::part(2));
    parts[2].angle = std::numbers::pi / 2;
    EXPECT_EQ(at({8, 0}), std::nullopt);
    EXPECT_EQ(at({6, 2}), Other::part(2));
}

TEST_F(Pick, APartsExtentIsWhereItHasTurned) {
    EXPECT_EQ(extent_of(scene, parts, 0), (Box{{-5, -1}, {5, -1}}));
    EXPECT_EQ(extent_of(scene, parts, 1), (Box{{-1, 3}, {1, 5}}));
    parts[2].angle = std::numbers::pi / 2;
    const Box turned = extent_of(scene, parts, 2);
    EXPECT_NEAR(turned.min.x, 6, 1e-9);
    EXPECT_NEAR(turned.max.y, 2, 1e-9);
}

TEST_F(Pick, APlaceIsFreeWhereNothingOverlaps) {
    EXPECT_TRUE(free({1.5, 1}));
    EXPECT_FALSE(free({0.9, 0}));
    EXPECT_TRUE(free({1.01, 0}, 0.5));
    EXPECT_FALSE(free({-3, -0.6}));
    EXPECT_TRUE(free({-3, -0.4}));
    EXPECT_FALSE(free({0, 4}, 0.1));
    EXPECT_FALSE(free({101, 0}));
    EXPECT_FALSE(free({7, 0.1}));
    parts[2].angle = std::numbers::pi / 2;
    EXPECT_TRUE(free({8, 0.1}));
}

TEST_F(Pick, WhatABallPassesThroughTakesNoPlace) {
    scene.parts[1].sensor = true;
    EXPECT_TRUE(free({0, 4}));
    parts[0].down = true;
    EXPECT_TRUE(free({-3, -1}));
    scene.balls[1].layer = 2;
    scene.balls[1].collides_with = 2;
    EXPECT_TRUE(free({3, 0}));
}

}  // namespace
}  // namespace flipside::lab
