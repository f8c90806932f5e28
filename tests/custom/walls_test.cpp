// No ball passes through a static part, for any mass, speed and load.

#include <random>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "in_small.hpp"

namespace flipside::custom::test {
namespace {

constexpr Box room{{-1, 0}, {1, 3}};

/// Balls of 30 to 100 mm and of masses from 10 g to 1 t, thrown about in a closed box with a turning bar.
Scene throng(unsigned seed, double speed, double restitution) {
    std::mt19937 random(seed);
    const auto pick = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) * 0x1p-32;
    };
    Scene scene = empty_scene({0, -9.81});
    scene.bounds = {{-1e9, -1e9}, {1e9, 1e9}};
    scene.materials[0].restitution = restitution;
    add_part(scene, {shape::Polyline{{room.min, {room.max.x, 0}, room.max, {room.min.x, room.max.y}}, true}});
    add_part(scene, {shape::Capsule{{-0.3, 1.5}, {0.3, 1.5}, 0.03}}).motion =
        motion::Turn{{0, 1.5}, pick(-30, 30), true};
    for (int i = 0; i < 12; ++i) {
        const double radius = pick(0.03, 0.1), mass = std::pow(10, pick(-2, 3));
        const Vec2 place{-0.75 + 0.5 * (i % 4), 0.25 + 1.2 * (i / 4)};
        add_ball(scene, place, {pick(-speed, speed), pick(-speed, speed)}, radius, mass);
    }
    return scene;
}

TEST(Walls, NothingPassesAStillPart) {
    for (const double speed : {1.0, 100.0, 1e4})
        for (const double restitution : {0.0, 0.7})
            for (unsigned seed = 0; seed < (flipside::test::in_small ? 1 : 4); ++seed) {
                const auto world = make_world(throng(seed, speed, restitution));
                run(*world, flipside::test::in_small ? 0.3 : 1, 1.0 / 30);
                for (const Ball& ball : world->balls())
                    EXPECT_TRUE(room.contains(ball.position))
                        << speed << " m/s, e = " << restitution << ", seed " << seed;
            }
}

}  // namespace
}  // namespace flipside::custom::test
