#include "lab/session/ball_edit.hpp"

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/session/session.hpp"
#include "world/limits.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {
namespace {

/// A ball on another one on a floor.
std::shared_ptr<const Scene> tower() {
    Scene scene = empty_scene({0, -9.81});
    for (const double y : {0.1, 0.3}) add_ball(scene, {0, y}).mass = 0.5;
    add_part(scene, segment({-5, 0}, {5, 0}), {"", 0, 0, 0});
    return std::make_shared<const Scene>(scene);
}

class EditedBalls : public testing::TestWithParam<const char*> {
  protected:
    EditedBalls() {
        for (int i = 0; i < 120; ++i) session.step(1.0 / 60);
    }
    [[nodiscard]] bool edit(const BallEdit& what) {
        const auto state = edited(*scene, session.world().save(), what);
        if (state) session.restore(*state);
        return state.has_value();
    }
    [[nodiscard]] std::span<const Ball> balls() const { return session.world().balls(); }

    std::shared_ptr<const Scene> scene = tower();
    Session session{scene, engine_named(GetParam()), Settings(engine_named(GetParam()).settings)};
};

TEST_P(EditedBalls, WhatLayOnABallThatIsGoneFalls) {
    ASSERT_TRUE(edit(edit::Remove{0}));
    ASSERT_EQ(balls().size(), 1U);
    EXPECT_EQ(balls()[0].number, 1U);
    const double before = balls()[0].position.y;
    for (int i = 0; i < 6; ++i) session.step(1.0 / 60);
    EXPECT_NEAR(balls()[0].position.y, before - 0.5 * 9.81 * 0.01, 0.01);
    EXPECT_FALSE(edit(edit::Remove{0}));
    EXPECT_FALSE(edit(edit::Throw{0, {1, 0}}));
}

TEST_P(EditedBalls, AThrownBallFlies) {
    ASSERT_TRUE(edit(edit::Throw{1, {0.5, 3}}));
    EXPECT_EQ(balls()[1].velocity, (Vec2{0.5, 3}));
    const Vec2 before = balls()[1].position;
    for (int i = 0; i < 12; ++i) session.step(1.0 / 60);
    EXPECT_NEAR(balls()[1].position.x, before.x + 0.1, 1e-3);
    EXPECT_NEAR(balls()[1].position.y, before.y + 0.6 - 0.5 * 9.81 * 0.04, 0.04);
}

TEST_P(EditedBalls, ANewBallGetsItsOwnNumberAndNoPlaceThatIsTaken) {
    Ball ball = balls()[0];
    EXPECT_FALSE(edit(edit::Add{ball}));
    ball.position = {2, 1};
    ball.number = 0;
    ASSERT_TRUE(edit(edit::Add{ball}));
    EXPECT_EQ(balls()[2].number, 2U);
    ball.position = {3, 1};
    ball.number = 17;
    ASSERT_TRUE(edit(edit::Add{ball}));
    EXPECT_EQ(balls()[3].number, 17U);
    EXPECT_EQ(session.world().save().next_number, 18U);
    for (int i = 0; i < 6; ++i) session.step(1.0 / 60);
    EXPECT_EQ(balls().size(), 4U);
    EXPECT_LT(balls()[3].position.y, 1);
}

TEST_P(EditedBalls, NoneIsThrownFasterThanAnyBallMayBe) {
    EXPECT_FALSE(edit(edit::Throw{1, {0, 1.01 * top_speed}}));
    EXPECT_EQ(balls()[1].velocity, (Vec2{}));
}

INSTANTIATE_TEST_SUITE_P(Lab, EditedBalls, testing::Values("custom", "box2d"),
                         [](const auto& test) { return std::string(test.param); });

TEST(BallEdit, ATableIsFullAtTheMostBallsOfAScene) {
    const Scene scene = empty_scene();
    State state;
    state.balls.resize(most_things);
    for (std::size_t i = 0; i < most_things; ++i) {
        state.balls[i].number = static_cast<BallNumber>(i);
        state.balls[i].position = {-50, -50};
    }
    const edit::Add add{{}};
    EXPECT_FALSE(edited(scene, state, add));
    state.balls.pop_back();
    EXPECT_TRUE(edited(scene, state, add));
}

TEST(BallEdit, NothingIsLeftOfABallThatIsGone) {
    State state;
    state.balls.resize(2);
    state.balls[1].number = 1;
    state.blocked = {{0, 0}, {0, 1}};
    state.reported_lost = {0, 1};
    const auto after = edited(empty_scene(), state, edit::Remove{1});
    ASSERT_TRUE(after);
    EXPECT_EQ(after->blocked, (std::vector<Blocked>{{0, 0}}));
    EXPECT_EQ(after->reported_lost, std::vector<BallNumber>{0});
}

class EditedFlight : public testing::TestWithParam<const char*> {};

// Engines whose paths last for longer than a step must not go on along an old one.
TEST_P(EditedFlight, GoesOnFromTheThrow) {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 50}, {1, 2});
    const Engine& engine = engine_named(GetParam());
    Session session(std::make_shared<const Scene>(scene), engine, Settings(engine.settings));
    for (int i = 0; i < 30; ++i) session.step(1.0 / 60);
    const Vec2 before = session.world().balls()[0].position;
    session.restore(*edited(scene, session.world().save(), edit::Throw{0, {-2, 3}}));
    for (int i = 0; i < 12; ++i) session.step(1.0 / 60);
    const double exactness = engine.name == "box2d" ? 0.04 : 1e-12;
    EXPECT_NEAR(session.world().balls()[0].position.x, before.x - 0.4, exactness);
    EXPECT_NEAR(session.world().balls()[0].position.y, before.y + 0.6 - 0.5 * 9.81 * 0.04, exactness);
}

INSTANTIATE_TEST_SUITE_P(Lab, EditedFlight, testing::Values("custom", "box2d", "reference"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace flipside::lab
