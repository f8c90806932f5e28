// Impacts at one instant, of which the physical model leaves the order open: the exact engines solve them
// pair by pair, first those with parts, and each in the order of the numbers of the balls. And slow contacts
// of balls that fall side by side are impacts too.

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

std::unique_ptr<World> start(const char* engine, const Scene& scene) {
    const Engine& used = lab::engine_named(engine);
    return used.make(std::make_shared<const Scene>(scene), Settings(used.settings));
}

class Simultaneous : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Engines, Simultaneous, testing::Values("custom", "reference"));

/// Turns back the velocity along a normal, with restitution e, if it goes against it.
void bounce(Vec2& velocity, Vec2 normal, double e) {
    const double closing = -dot(velocity, normal);
    if (closing > 1e-12) velocity += (1 + e) * closing * normal;
}

/// Changes the velocities of two balls of the same mass along the normal from b to a, with restitution e, if
/// they approach. Returns whether they do.
bool collide(Vec2& a, Vec2& b, Vec2 normal, double e) {
    const double closing = -dot(a - b, normal);
    if (closing <= 1e-12) return false;
    a += (1 + e) / 2 * closing * normal;
    b -= (1 + e) / 2 * closing * normal;
    return true;
}

TEST_P(Simultaneous, ImpactsWithPartsComeFirst) {
    constexpr double r = 0.125, e = 0.8;
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    scene.materials[0].restitution = std::sqrt(e);
    const Material part{"", std::sqrt(e), 0, 0};
    add_part(scene, segment({0, -1}, {0, 1}), part);
    add_part(scene, segment({-1, 0}, {2, 0}), part);
    // One touches the wall. The other touches the floor, and hits the first obliquely, so that both are
    // driven into what they touch.
    const double rise = r / 2, across = std::sqrt(4 * r * r - rise * rise);
    add_ball(scene, {r, r + rise}, {}, r);
    add_ball(scene, {r + across + 0.1, r}, {-1, 0}, r);

    std::array<Vec2, 2> expected{Vec2{}, Vec2{-1, 0}};
    const Vec2 normal{-across / (2 * r), rise / (2 * r)};
    for (int round = 0; round < 100; ++round) {
        collide(expected[0], expected[1], normal, e);
        bounce(expected[0], {1, 0}, e);
        bounce(expected[1], {0, 1}, e);
    }
    const auto world = start(GetParam(), scene);
    world->step(0.11);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_LT(length(world->balls()[i].velocity - expected[i]), 1e-10) << i;
}

TEST_P(Simultaneous, ImpactsOfBallsComeInTheOrderOfTheirNumbers) {
    constexpr double r = 0.125, e = 0.9;
    const Vec2 oblique{0.4, std::sqrt(1 - 0.16)};
    // One ball lies on the floor beside a second. A third hits the first from above, so that it bounces off
    // the floor into both at once.
    for (const bool second_first : {true, false}) {
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        scene.materials[0].restitution = std::sqrt(e);
        add_part(scene, segment({-2, 0}, {2, 0}), {"", std::sqrt(e), 0, 0});
        const auto add_second = [&] { add_ball(scene, {-2 * r, r}, {}, r); };
        if (second_first) add_second();
        const std::size_t first = scene.balls.size();
        add_ball(scene, {0, r}, {}, r);
        const std::size_t third = scene.balls.size();
        add_ball(scene, Vec2{0, r} + (2 * r + 0.1) * oblique, -1.0 * oblique, r);
        const std::size_t second = second_first ? 0 : scene.balls.size();
        if (!second_first) add_second();

        std::vector<Vec2> expected(3);
        expected[third] = -1.0 * oblique;
        const auto hits_second = [&] { return collide(expected[second], expected[first], {-1, 0}, e); };
        const auto hits_third = [&] { return collide(expected[third], expected[first], oblique, e); };
        for (int round = 0; round < 100; ++round) {
            for (const std::size_t i : {first, second}) bounce(expected[i], {0, 1}, e);
            if (second_first ? !hits_second() && !hits_third() : !hits_third() && !hits_second()) break;
        }
        const auto world = start(GetParam(), scene);
        world->step(0.11);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_LT(length(world->balls()[i].velocity - expected[i]), 1e-10) << i << second_first;
    }
}

TEST_P(Simultaneous, SlowContactsInFlightAreImpacts) {
    constexpr double r = 0.125, gap = 0x1p-14, v = 0.05;
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0.1;
    // A ball meets one beside it, and soon after that one below it.
    add_ball(scene, {0, 0}, {v, 0}, r);
    add_ball(scene, {2 * r + gap, 0}, {}, r);
    add_ball(scene, {0, -2 * r - gap}, {0, v / 2}, r);
    const auto world = start(GetParam(), scene);
    constexpr double time = 0.1;
    world->step(time);
    EXPECT_EQ(world->statistics().handed_over, 0U);
    // By the second contact the ball has moved along the one below it. That turns the normal, so that the
    // velocities along the tangent change by up to this part of v.
    const double first = gap / v, second = 2 * first, turn = 0.5 * v * second / (2 * r);
    const double fall = -0.5 * 9.81 * time * time, near = 2 * turn * v * time;
    const auto balls = world->balls();
    EXPECT_NEAR(balls[1].position.x, 2 * r + gap + v / 2 * (time - first), near);
    EXPECT_NEAR(balls[0].position.y, fall + v / 4 * (time - second), near);
    EXPECT_NEAR(balls[2].position.y, -2 * r - gap + fall + v / 2 * second + v / 4 * (time - second), near);
}

}  // namespace
}  // namespace flipside
