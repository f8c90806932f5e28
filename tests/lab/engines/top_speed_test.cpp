// Closed boxes with a restitution above 1: nothing leaves, nothing becomes infinite, and at the top speed the
// step is refused by every engine that gets there.

#include <cmath>

#include <gtest/gtest.h>

#include "lab/engines/every_solver.hpp"
#include "world/limits.hpp"
#include "world/refusal.hpp"
#include "world/scene_builder.hpp"
#include "world/state_file.hpp"

namespace flipside {
namespace {

Scene closed_box(double restitution) {
    Scene scene = empty_scene({0, -9.81});
    scene.bounds = {{-1.5, -1.5}, {1.5, 1.5}};
    const Shape walls{shape::Polyline{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, true}};
    add_part(scene, walls, {"", restitution, 0, 0}).name = "walls";
    add_ball(scene, {0, 0}, {0.3, 1}, 0.1);
    add_ball(scene, {0.4, 0.3}, {-1, 0.2}, 0.1);
    return scene;
}

bool is_finite(const Event& event) {
    return std::isfinite(event.time) && flipside::is_finite(event.point) &&
           flipside::is_finite(event.normal) && std::isfinite(event.speed) && std::isfinite(event.impulse);
}

TEST(TopSpeed, IsRefusedAndTheWorldIsAsBefore) {
    for (const double restitution : {1.3, 1000.0})
        for (const auto& [engine, settings] : lab::every_solver()) {
            const auto where = ::testing::Message() << engine->name << ", restitution " << restitution;
            const auto scene = std::make_shared<const Scene>(closed_box(restitution));
            const auto world = engine->make(scene, settings);
            std::string refusal, before;
            try {
                for (int step = 0; step < 600; ++step) {
                    before = to_json(world->save(), *scene);
                    world->step(1.0 / 60);
                    for (const Event& event : world->events()) EXPECT_TRUE(is_finite(event)) << where;
                    for (const Ball& ball : world->balls()) EXPECT_TRUE(within_top_speed(ball)) << where;
                }
            } catch (const Refusal& refused) {
                refusal = refused.what();
            }
            // Box2D moves nothing further than two of its units in a step, so it never gets there.
            if (engine->name == "box2d") continue;
            // The simple solver lets what is that fast through the walls.
            const bool tunnels = world->statistics().solver == "simple";
            if (tunnels) {
                EXPECT_EQ(refusal, "");
                EXPECT_EQ(world->balls().size(), 0U) << where;
                continue;
            }
            EXPECT_TRUE(refusal.starts_with(std::string(engine->name) + ": ball ")) << where << refusal;
            EXPECT_NE(refusal.find("the top speed"), std::string::npos) << where << refusal;
            EXPECT_EQ(to_json(world->save(), *scene), before) << where;
            EXPECT_EQ(world->balls().size(), 2U) << where;
            EXPECT_THROW(world->step(1.0 / 60), Refusal) << where;
            // Another state gets it going again.
            State slow = world->save();
            for (Ball& ball : slow.balls) ball.velocity = {};
            world->restore(slow);
            EXPECT_NO_THROW(world->step(1e-3)) << where;
        }
}

// In a world that sleeps nothing but the clock changes.
TEST(LastTime, IsRefusedAndTheWorldIsAsBefore) {
    Scene scene = empty_scene({0, -9.81});
    add_part(scene, segment({-1, 0}, {1, 0}));
    add_ball(scene, {0, 0.1}, {}, 0.1);
    const auto shared = std::make_shared<const Scene>(scene);
    for (const auto& [engine, settings] : lab::every_solver()) {
        const auto world = engine->make(shared, settings);
        for (int step = 0; step < 60; ++step) world->step(1.0 / 60);
        State late = world->save();
        late.clock = {last_time - 0.5, 0};
        late.origin = nullptr;
        world->restore(late);
        for (int step = 0; step < 16; ++step) world->step(1.0 / 64);
        const std::string before = to_json(world->save(), *shared);
        EXPECT_THROW(world->step(1.0), Refusal) << engine->name;
        EXPECT_EQ(to_json(world->save(), *shared), before) << engine->name;
        EXPECT_THROW(world->step(1.0 / 64), Refusal) << engine->name;
    }
}

TEST(TopSpeed, FilesMayNotAskForMore) {
    Scene scene = empty_scene();
    add_ball(scene, {}, {8e8, 8e8});
    for (const auto& [engine, settings] : lab::every_solver()) {
        if (engine->name == "box2d") continue;
        const auto world = engine->make(std::make_shared<const Scene>(scene), settings);
        EXPECT_THROW(world->step(1e-6), Refusal) << engine->name;
    }
}

}  // namespace
}  // namespace flipside
