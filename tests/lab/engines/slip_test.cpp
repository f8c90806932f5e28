// Balls that roll, begin to slip because friction is too weak, and roll again: the engines that find events
// at their times.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

constexpr double fall = 9.81, rim = 0.1;  // m/s², m: gravity, radius

std::vector<std::unique_ptr<World>> exact_worlds(const Scene& scene) {
    std::vector<std::unique_ptr<World>> worlds;
    for (const char* name : {"custom", "reference"}) {
        const Engine& engine = lab::engine_named(name);
        worlds.push_back(engine.make(std::make_shared<const Scene>(scene), Settings(engine.settings)));
    }
    return worlds;
}

void run_for(World& world, double seconds, double dt) {
    for (int step = 0; step < std::lround(seconds / dt); ++step) world.step(dt);
}

// On a floor, a pull along it is at first too strong for rolling; then drag has taken enough of it.
TEST(Slip, EndsWhenDragHasSlowedTheBall) {
    const double pull = 12, drag = 2, friction = 0.3, rubbed = pull - friction * fall;
    Scene scene = empty_scene({pull, -fall});
    scene.damping = drag;
    scene.materials[0].friction = friction;
    add_ball(scene, {0, rim});
    add_part(scene, segment({-1, 0}, {50, 0}), {"", 0, friction, 0});
    // It slips at (v, x) with v' = rubbed − drag·v, until v is the speed of the rim, 2µgt.
    const auto speed = [&](double t) { return rubbed / drag * (1 - std::exp(-drag * t)); };
    double before = 0.1, after = 1;
    for (int halving = 0; halving < 60; ++halving) {
        const double t = (before + after) / 2;
        (speed(t) > 2 * friction * fall * t ? before : after) = t;
    }
    const double slipped = rubbed / drag * before - speed(before) / drag;
    // Then it rolls with v' = ⅔(pull − drag·v).
    const double rolled = 1 - before, rate = 2 * drag / 3, faster = speed(before) - pull / drag;
    const double left = std::exp(-rate * rolled);
    for (const auto& world : exact_worlds(scene))
        for (const double dt : {1.0 / 60, 1.0 / 1000}) {
            const auto start = world->save();
            run_for(*world, 1, dt);
            const Ball& ball = world->balls()[0];
            EXPECT_NEAR(ball.velocity.x, pull / drag + faster * left, 1e-11);
            EXPECT_NEAR(ball.spin, -ball.velocity.x / rim, 1e-10);
            EXPECT_NEAR(ball.position.x, slipped + pull / drag * rolled + faster * (1 - left) / rate, 1e-11);
            world->restore(start);
        }
}

// A ball rolls up a hill of 1 m. Where it is steep the ball slips, nearer to the top it rolls again.
TEST(Slip, EndsNearTheTopOfAHill) {
    const double friction = 0.2, slope = 24.5 * std::numbers::pi / 180, speed = 1.6;
    // The hill is turned so that the ball starts on the vertical line through its centre, just before the
    // place at 23.9 degrees from which on friction is strong enough.
    Scene scene = empty_scene(fall * Vec2{std::sin(slope), -std::cos(slope)});
    scene.materials[0].friction = friction;
    add_ball(scene, {0, 1 + rim}, {-speed, 0}).spin = speed / rim;
    add_part(scene, {shape::Circle{{0, 0}, 1}}, {"", 0, friction, 0});
    const auto slip = [](const Ball& ball) {
        return dot(ball.velocity, perp(unit(ball.position))) - rim * ball.spin;
    };
    std::vector<Vec2> ends;
    for (const auto& world : exact_worlds(scene)) {
        run_for(*world, 0.005, 0.001);
        EXPECT_GT(std::abs(slip(world->balls()[0])), 1e-4);
        run_for(*world, 0.025, 0.001);
        EXPECT_NEAR(slip(world->balls()[0]), 0, 1e-14);
        EXPECT_NEAR(length(world->balls()[0].position), 1 + rim, 1e-14);
        ends.push_back(world->balls()[0].position);
    }
    EXPECT_LT(length(ends[0] - ends[1]), 1e-14);
}

}  // namespace
}  // namespace flipside
