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

    void run(auto&& step) {
        guard.run(table, balls, step, [&](const State& before) { balls = restored = before.balls; });
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

TEST(StepGuard, ARefusedStepIsUndoneByTheEngineThatCan) {
    StepGuard guard{"engine"};
    int undone = 0;
    const auto undo = [&] { ++undone; };
    guard.attempt([] {}, undo);
    EXPECT_EQ(undone, 0);
    EXPECT_THROW(guard.attempt([] { throw Refusal("the last time"); }, undo), Refusal);
    EXPECT_EQ(undone, 1);
    EXPECT_THROW(guard.attempt([] { FAIL() << "no step after a refusal"; }, undo), Refusal);
    EXPECT_EQ(undone, 1);
}

}  // namespace
}  // namespace flipside
