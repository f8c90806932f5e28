#include "world/step_guard.hpp"

#include <gtest/gtest.h>

#include "world/scene_builder.hpp"

namespace flipside {
namespace {

struct Guarded {
    std::shared_ptr<const Scene> scene = std::make_shared<const Scene>(empty_scene());
    Table table{scene};
    StepGuard guard{"engine"};
    std::vector<Ball> balls = std::vector<Ball>(3);
    std::vector<Ball> restored;

    void run(auto&& step, bool balls_move = true) {
        guard.run(
            table, balls, step, [&](const State& before) { balls = restored = before.balls; }, balls_move);
    }
};

TEST(StepGuard, ARefusedStepIsGivenTheBallsBeforeIt) {
    Guarded world;
    world.run([&] { world.balls[1].position = {1, 0}; });
    const std::vector<Ball> before = world.balls;
    const auto move_too_far = [&] {
        world.balls.pop_back();
        world.balls[0].position = {2 * farthest, 0};
    };
    EXPECT_THROW(world.run(move_too_far), Refusal);
    EXPECT_EQ(world.restored, before);
    EXPECT_THROW(world.run([] { FAIL() << "no step after a refusal"; }), Refusal);
    world.guard.forget();
    EXPECT_NO_THROW(world.run([&] { world.balls.assign(3, {}); }));
}

TEST(StepGuard, BallsThatAChangeBroughtBeyondTheLimitsAreRefusedBeforeTheStep) {
    Guarded world;
    world.balls[1].velocity = {2 * top_speed, 0};
    EXPECT_THROW(world.run([] { FAIL() << "no step"; }), Refusal);
}

TEST(StepGuard, AStepThatMovesNoBallIsRefusedWithTheBallsAsTheyAre) {
    Guarded world;
    world.balls[1].position = {1, 0};
    const std::vector<Ball> before = world.balls;
    EXPECT_THROW(world.run([] { throw Refusal("the last time"); }, false), Refusal);
    EXPECT_EQ(world.restored, before);
}

}  // namespace
}  // namespace flipside
