// A ball exactly on the bounds of its scene: Box::contains decides, on every engine alike, and the step takes
// no longer than any other.

#include <chrono>

#include <gtest/gtest.h>

#include "lab/engines/every_solver.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

struct Start {
    Vec2 position, velocity, gravity;
    bool leaves = false;
};

TEST(OnTheBounds, ContainsDecidesOnEveryEngine) {
    const Start starts[] = {{{0, 0.5}, {0, 0}, {0, 0}, false},   {{0, 0.5}, {0, 1}, {0, 0}, false},
                            {{0, 0.5}, {0, 1}, {0, -9}, false},  {{0, 0.5}, {0, -1}, {9, -9}, false},
                            {{0, 0.5}, {0, 0}, {9, 0}, false},   {{0, 0.5}, {-1, 0}, {0, 0}, true},
                            {{0, 0.5}, {1, 0}, {-9, 0}, false},  {{0, 0.5}, {0, 1}, {-9, 0}, true},
                            {{0, 0.5}, {0, 0}, {-9, 0}, true},   {{1, 0.5}, {0, 1}, {0, -9}, false},
                            {{1, 0.5}, {1e-3, 0}, {0, 0}, true}, {{0.5, 0}, {0, 0}, {0, 0}, false},
                            {{0.5, 0}, {1, 0}, {0, 0}, false},   {{0.5, 1}, {1, 0}, {0, 0}, false},
                            {{0.5, 1}, {1, 0}, {0, 9}, true},    {{0, 0}, {0, 1}, {0, 0}, false},
                            {{1, 1}, {-1, 0}, {0, 0}, false},    {{1, 1}, {-1, 0}, {0, -9}, false},
                            {{1, 1}, {0, 0}, {0, 9}, true},      {{0, 1}, {0, 0}, {0, 0}, false}};
    constexpr double dt = 1.0 / 60;
    for (const auto& [engine, settings] : lab::every_solver())
        for (const Start& start : starts)
            for (const double damping : {0.0, 0.1}) {
                Scene scene = empty_scene(start.gravity);
                scene.bounds = {{0, 0}, {1, 1}};
                scene.damping = damping;
                add_ball(scene, start.position, start.velocity, 0.01);
                const auto world = engine->make(std::make_shared<const Scene>(scene), settings);
                const auto began = std::chrono::steady_clock::now();
                int lost = 0;
                for (int step = 0; step < 3; ++step) {
                    world->step(dt);
                    for (const Event& event : world->events()) {
                        EXPECT_EQ(event.kind, EventKind::lost);
                        EXPECT_FALSE(scene.bounds.contains(event.point)) << engine->name;
                        ++lost;
                    }
                }
                const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
                const auto where = ::testing::Message()
                                   << engine->name << " at " << start.position.x << ", " << start.position.y
                                   << " with " << start.velocity.x << ", " << start.velocity.y << " under "
                                   << start.gravity.x << ", " << start.gravity.y;
                EXPECT_EQ(lost, start.leaves ? 1 : 0) << where;
                EXPECT_EQ(world->balls().size(), start.leaves ? 0U : 1U) << where;
                EXPECT_LT(took.count(), 1) << where;
            }
}

}  // namespace
}  // namespace flipside
