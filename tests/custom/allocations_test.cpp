// A step allocates nothing after the busiest step of a scene.

#include "lab/process/allocations.hpp"

#include <gtest/gtest.h>

#include "custom/broad_phase/registry.hpp"
#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

TEST(Allocations, NoneInAStepAfterWarmUp) {
    Scene scene = empty_scene({0, -2});
    for (int i = 0; i < 100; ++i) {
        const int row = i / 10, column = i % 10;
        add_ball(scene, {0.3 * column, 0.3 * row}, {i % 7 - 3.0, i % 5 - 2.0});
    }
    add_part(scene, {shape::Polyline{{{-0.5, -0.5}, {4, -0.5}, {4, 4}, {-0.5, 4}}, true}});
    add_part(scene, segment({1, 3.5}, {3, 3.6})).sensor = true;
    add_part(scene, segment({1, 3.4}, {2, 3.4})).motion = motion::Turn{{1.5, 3.4}, 2, true};
    add_part(scene, {shape::Polygon{{{3.2, 3.2}, {3.6, 3.2}, {3.4, 3.5}}}}).motion =
        motion::Turn{{3.4, 3.3}, 2, true};
    for (const BroadPhaseKind& kind : broad_phases)
        for (const auto* solver : {"simple", "continuous"}) {
            const auto world = make_world(scene, {{"broad_phase", kind.name}, {"solver", solver}});
            const State start = world->save();
            run(*world, 3);
            world->restore(start);  // the same steps need no more memory
            const std::uint64_t before = lab::allocations();
            run(*world, 3);
            EXPECT_EQ(lab::allocations(), before) << kind.name << ", " << solver;
        }
}

TEST(Allocations, NoneInAHeapThatWasNeverSeenBefore) {
    Scene scene = empty_scene({0, -9.8});
    scene.materials[0].restitution = 0.7;
    for (int i = 0; i < 200; ++i)
        add_ball(scene, {0.25 * (i % 10), 0.5 + 0.3 * (i / 10)}, {std::sin(3.0 * i), 0});
    add_part(scene, {shape::Polyline{{{-0.2, 90}, {-0.2, 0}, {2.5, 0}, {2.5, 90}}, false}}, {"", 0.7, 0, 0});
    const auto world = make_world(scene);
    run(*world, 0.1);
    const std::uint64_t before = lab::allocations();
    run(*world, 4);
    EXPECT_EQ(lab::allocations(), before);
}

}  // namespace
}  // namespace flipside::custom::test
