// When balls that do not come from the scene's start enter sensors, on every engine: a ball that is launched
// or added inside one enters it there and then; a ball that the scene begins with is inside already.

#include <gtest/gtest.h>

#include "lab/engines/every_solver.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {
namespace {

enum class Way { launched, launched_after_a_restore, added };

/// A sensor around the launcher and around ball 0, which stays there.
Scene scene_with_sensor() {
    Scene scene = empty_scene();
    add_part(scene, {shape::Circle{{0, 0}, 1}}).sensor = true;
    add_ball(scene, {-0.5, 0.5});
    Launcher launcher;
    launcher.direction = {1, 0};
    launcher.slowest = launcher.fastest = 3;
    launcher.ball.radius = 0.1;
    launcher.ball.mass = 1;
    scene.launcher = launcher;
    return scene;
}

TEST(Sensors, AreEnteredByBallsThatComeIntoThemAtAnyStep) {
    constexpr double dt = 1.0 / 60;
    const auto scene = std::make_shared<const Scene>(scene_with_sensor());
    for (const auto& [engine, settings] : every_solver())
        for (const int first : {0, 10})
            for (const Way way : {Way::launched, Way::launched_after_a_restore, Way::added}) {
                auto world = engine->make(scene, settings);
                std::vector<Event> sensed;
                for (int step = 0; step < 40; ++step) {
                    if (step == first && way == Way::launched_after_a_restore) {
                        const State saved = world->save();
                        world = engine->make(scene, settings);
                        world->restore(saved);
                    }
                    if (step == first && way == Way::added) {
                        Ball ball = scene->launcher->ball;
                        ball.velocity = {3, 0};
                        world->add(ball);
                    } else if (step == first) {
                        world->apply(control::Launch{});
                    }
                    world->step(dt);
                    for (const Event& event : world->events())
                        if (event.kind == EventKind::sensor_begin || event.kind == EventKind::sensor_end)
                            sensed.push_back(event);
                }
                SCOPED_TRACE(std::string(engine->name) + " step " + std::to_string(first) + " way " +
                             std::to_string(static_cast<int>(way)));
                ASSERT_EQ(sensed.size(), 2U);
                EXPECT_EQ(sensed[0].kind, EventKind::sensor_begin);
                EXPECT_EQ(sensed[1].kind, EventKind::sensor_end);
                for (const Event& event : sensed) EXPECT_EQ(event.ball, 1U);
                EXPECT_NEAR(sensed[0].time, first * dt, 1.01 * dt);
                EXPECT_NEAR(sensed[1].time, first * dt + 1.1 / 3, 1.01 * dt);
            }
}

}  // namespace
}  // namespace flipside::lab
