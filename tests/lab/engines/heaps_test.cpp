// Heaps that the bespoke engine has brought to rest, of the hard cases 24 and 33 and others: the exact engine
// takes them up and finds them in equilibrium. So nothing in them moves any more.

#include <cmath>

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/session/run_settings.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {
namespace {

Scene heap_scene(double friction) {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0.5;
    scene.materials[0].friction = friction;
    return scene;
}
Scene falling_column(double gap, double heavy) {
    Scene scene = heap_scene(0);
    add_part(scene, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
    for (int i = 0; i < 10; ++i) add_ball(scene, {0, 0.1 + (0.2 + gap) * i}, {}, 0.1, i % 2 == 0 ? 1 : heavy);
    return scene;
}
/// Fifty balls that rain into a V.
Scene rain_in_a_groove(double friction) {
    Scene scene = heap_scene(friction);
    add_part(scene, {shape::Polyline{{{-4, 4}, {0, 0}, {4, 4}}, false}}, {"", 0.5, friction, 0});
    for (int i = 0; i < 50; ++i) {
        const int row = i / 9;
        add_ball(scene, {-0.9 + 0.21 * (i % 9) + 0.003 * row, 1.2 + 0.25 * row});
    }
    return scene;
}

std::unique_ptr<World> world_of(const char* name, const Scene& scene) {
    const Engine& engine = engine_named(name);
    const auto shared = std::make_shared<const Scene>(scene);
    return engine.make(shared, settings_for(engine, *shared, {}));
}

TEST(RestedHeaps, AreInEquilibriumOnTheReference) {
    for (const Scene& scene :
         {falling_column(0.01, 1), falling_column(0, 1000), rain_in_a_groove(0), rain_in_a_groove(0.5)}) {
        const auto bespoke = world_of("custom", scene), exact = world_of("reference", scene);
        while (bespoke->time() < 20 && bespoke->statistics().asleep < scene.balls.size())
            bespoke->step(1.0 / 60);
        ASSERT_EQ(bespoke->statistics().asleep, scene.balls.size());
        exact->restore(bespoke->save());
        for (int i = 0; i < 60; ++i) ASSERT_NO_THROW(exact->step(1.0 / 60));
        EXPECT_EQ(exact->statistics().asleep, scene.balls.size());
        EXPECT_EQ(exact->statistics().impacts, 0U);
        for (std::size_t i = 0; i < scene.balls.size(); ++i)
            EXPECT_EQ(exact->balls()[i].position, bespoke->balls()[i].position);
    }
}

}  // namespace
}  // namespace flipside::lab
