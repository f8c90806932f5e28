#include "app/window/playfield/nearest.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lab/files/assets.hpp"
#include "lab/lessons/brute_force_gap.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {
namespace {

/// On a grid over the scene and half its size around it.
template <class Visit>
void at_places(const Scene& scene, int count, const Visit& visit) {
    const Vec2 size = scene.bounds.max - scene.bounds.min;
    for (int i = 0; i <= count; ++i)
        for (int j = 0; j <= count; ++j)
            visit(scene.bounds.min +
                  Vec2{size.x * (2.0 * i / count - 0.5), size.y * (2.0 * j / count - 0.5)});
}

TEST(Nearest, IsAsNearAsAnyPlaceOfTheOutline) {
    int compared = 0;
    for (const char* name : {"pinball", "toy", "rain"}) {
        const Scene scene = load_scene(lab::scene_file(name));
        for (const Primitive& primitive : surface_of(scene))
            at_places(scene, 6, [&](Vec2 place) {
                const Vec2 nearest = nearest_of(primitive, place);
                if (nearest == place) return;  // within a solid
                const double by_force = lab::distance_by_brute_force(place, primitive, 2000);
                const double size = length(scene.bounds.max - scene.bounds.min);
                EXPECT_LE(length(place - nearest), by_force + 1e-12) << name << ' ' << primitive.part;
                EXPECT_GE(length(place - nearest), by_force - 1e-4 * size) << name << ' ' << primitive.part;
                ++compared;
            });
    }
    EXPECT_GT(compared, 5000);
}

RC_GTEST_PROP(Nearest, LiesInTheBoxOfItsPrimitiveAndIsItsOwnNearest, ()) {
    const auto real = [] { return *rc::gen::inRange(-1000, 1000) / 1000.0; };
    const Vec2 a{real(), real()}, b{real() + 3, real()};
    const double radius = 0.1 + std::abs(real());
    const primitive::Taper taper{a, b, radius, 0.5 * radius};
    const primitive::Arc arc{a, radius, real(), real() + 3};
    for (const Primitive& one :
         {Primitive{taper, 0}, Primitive{arc, 0}, Primitive{primitive::Segment{a, b}, 0}}) {
        const Vec2 nearest = nearest_of(one, 4 * Vec2{real(), real()});
        const Vec2 again = nearest_of(one, nearest);
        RC_ASSERT(length(again - nearest) < 1e-12);
    }
}

TEST(Nearest, IsThePlaceItselfWithinASolid) {
    const Primitive disc{primitive::Circle{{1, 1}, 0.5}, 0};
    EXPECT_EQ(nearest_of(disc, {1.2, 1.1}), (Vec2{1.2, 1.1}));
    const Primitive square{primitive::Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 0};
    EXPECT_EQ(nearest_of(square, {0.3, 0.9}), (Vec2{0.3, 0.9}));
    EXPECT_NEAR(length(nearest_of(square, {0.3, 1.5}) - Vec2{0.3, 1}), 0, 1e-15);
}

}  // namespace
}  // namespace flipside::app
