// Predicted answers for single balls: numbers as in the hard cases of docs/accuracy.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "reference/support.hpp"

namespace flipside::reference::test {
namespace {

using std::numbers::pi;
constexpr double g = 9.81;

TEST(Reference, ZenoDropRestsInTime) {
    for (const char* bits : {"53", "113"}) {
        Scene scene = empty_scene({0, -g});
        scene.rest_speed = 0;
        add_ball(scene, {0, 1.1});
        add_part(scene, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
        const auto world = make_world(scene, {{"precision", bits}});
        const double rest = std::sqrt(2 / g) * 3;
        double last = 0;
        while (world->time() < rest + 0.1) {
            world->step(1.0 / 60);
            for (const Event& event : world->events())
                if (event.kind == EventKind::impact) last = event.time;
        }
        EXPECT_NEAR(last, rest, 2e-7);
        EXPECT_EQ(world->balls()[0].velocity, Vec2{});
        EXPECT_NEAR(world->balls()[0].position.y, 0.1, 1e-15);
    }
}

TEST(Reference, DragHasItsClosedForm) {
    Scene scene = empty_scene({0, -g});
    scene.damping = 0.7;
    scene.rest_speed = 0;
    add_ball(scene, {0, 2}, {3, 0});
    add_part(scene, segment({-50, 0}, {50, 0}), {"", 1, 0, 0});
    const auto world = make_world(scene);
    double t = 0.5;  // Newton on y(t) = 0.1
    for (int i = 0; i < 30; ++i) {
        const double e = (1 - std::exp(-0.7 * t)) / 0.7, f = (t - e) / 0.7;
        t += (2 - g * f - 0.1) / (g * e);
    }
    while (world->statistics().impacts == 0) world->step(1.0 / 60);
    const Event& hit = world->events().front();
    EXPECT_NEAR(hit.time, t, 1e-14);
    EXPECT_NEAR(hit.point.x, 3 * (1 - std::exp(-0.7 * t)) / 0.7, 1e-14);
}

TEST(Reference, BowlIsAPendulumInBothPrecisions) {
    for (const char* bits : {"53", "113"}) {
        Scene scene = empty_scene({0, -g});
        add_part(scene, {shape::Arc{{0, 0}, 1.1, pi, 2 * pi}});
        const double start = pi / 3;
        add_ball(scene, {std::sin(start), -std::cos(start)});
        double a = 1, b = std::cos(start / 2);
        for (int i = 0; i < 8; ++i) {
            const double mean = (a + b) / 2;
            b = std::sqrt(a * b);
            a = mean;
        }
        const double period = 2 * pi * std::sqrt(1 / g) / a;
        const auto world = make_world(scene, {{"precision", bits}});
        run(*world, 10 * period, period / 100);
        EXPECT_NEAR(world->balls()[0].position.x, std::sin(start), 2e-13);
        EXPECT_EQ(world->statistics().impacts, 0U);
    }
}

TEST(Reference, LeavesTheCircleAtTwoThirds) {
    Scene scene = empty_scene({0, -g});
    add_part(scene, {shape::Circle{{0, 0}, 0.9}});
    const double start = 0.01;
    add_ball(scene, {std::sin(start), std::cos(start)});
    const auto world = make_world(scene);
    while (world->balls()[0].position.y > 0) world->step(1.0 / 30);
    const double cosine = 2.0 / 3 * std::cos(start);
    EXPECT_NEAR(world->balls()[0].velocity.x, std::sqrt(g * cosine) * cosine, 1e-12);
}

TEST(Reference, SlidesThenRollsDownAnIncline) {
    // 14: a ball thrown along a level floor rolls after v/(3µg) with 2v/3.
    Scene scene = empty_scene({0, -g});
    scene.materials[0].friction = 0.3;
    add_ball(scene, {0, 0.1}, {3, 0});
    add_part(scene, segment({-1, 0}, {50, 0}), {"", 0, 0.3, 0});
    const auto world = make_world(scene);
    const double rolls = 3 / (3 * 0.3 * g);
    run(*world, rolls / 2, rolls / 20);
    EXPECT_NEAR(world->balls()[0].velocity.x, 3 - 0.3 * g * rolls / 2, 1e-13);
    run(*world, rolls, rolls / 20);
    EXPECT_NEAR(world->balls()[0].velocity.x, 2, 1e-13);
    EXPECT_NEAR(world->balls()[0].spin, -20, 1e-12);
    // And from rest on a slope of 20°, a third slower than without friction.
    Scene slope = empty_scene({0, -g});
    slope.materials[0].friction = 0.3;
    const Vec2 along{std::cos(pi / 9), -std::sin(pi / 9)};
    add_ball(slope, 0.1 * perp(along));
    add_part(slope, segment(-1 * along, 40 * along), {"", 0, 0.3, 0});
    const auto rolling = make_world(slope);
    run(*rolling, 1, 1.0 / 50);
    EXPECT_NEAR(dot(rolling->balls()[0].position, along), g * std::sin(pi / 9) / 3, 1e-13);
}

TEST(Reference, GrazesOrMisses) {
    for (const double delta : {1e-6, 1e-12, -1e-12}) {
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        add_part(scene, {shape::Circle{{0, 0}, 0.4}});
        add_ball(scene, {-2, 0.5 * (1 - delta)}, {3, 0});
        const auto world = make_world(scene);
        run(*world, 2);
        const double exact = delta > 0 ? 2 * std::acos(1 - delta) : 0;
        // Rounding of the start itself is 1e-4 of the smallest depth.
        EXPECT_NEAR(angle_of(world->balls()[0].velocity), exact, 1e-3 * exact);
    }
}

TEST(Reference, SmoothJointsGiveNoBump) {
    Scene scene = empty_scene({0, -g});
    std::vector<Vec2> points;
    for (int i = 0; i <= 1000; ++i) points.push_back({0.05 * i, 0.3 * 0.05 * i});
    add_part(scene, {shape::Polyline{points, false}}, {"", 0.5, 0, 0});
    const Vec2 along = unit({1, 0.3});
    add_ball(scene, 45 * along + 0.1 * perp(along));
    const auto world = make_world(scene);
    run(*world, 4, 1.0 / 10);
    const double a = g * 0.3 / std::sqrt(1.09);
    EXPECT_NEAR(dot(world->balls()[0].velocity, along), -4 * a, 1e-11);
    EXPECT_NEAR(dot(world->balls()[0].position, perp(along)), 0.1, 1e-12);
}

TEST(Reference, FlipperHitsByItsSurfaceSpeed) {
    // 19: v' = −e·v + (1 + e)·u.
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    Part& flipper = add_part(scene, {shape::Flipper{{0, 0}, 1, 0.05, 0.05, 0}}, {"", 0.7, 0, 0});
    flipper.motion = motion::Flip{Side::left, pi / 2, 20, 10};
    add_ball(scene, {0.8, 0.3}, {0, -1});
    const auto world = make_world(scene);
    world->apply(control::Flip{Side::left, true});
    while (world->statistics().impacts == 0) world->step(1.0 / 240);
    const Event hit = world->events().front();
    const Vec2 surface = cross(20, hit.point);
    const double in = -1 * hit.normal.y, u = dot(surface, hit.normal);
    EXPECT_NEAR(hit.speed, u - in, 1e-12);
    EXPECT_NEAR(dot(world->balls()[0].velocity, hit.normal), -0.7 * in + 1.7 * u, 1e-12);
    EXPECT_NEAR(length(hit.point - Vec2{hit.point.x, hit.point.y}), 0, 0);
    EXPECT_NEAR(length(world->balls()[0].velocity - dot(world->balls()[0].velocity, hit.normal) * hit.normal),
                std::abs(hit.normal.x), 1e-12);
}

TEST(Reference, SensorsAreCrossedAtTheirExactTimes) {
    Scene scene = empty_scene();
    add_ball(scene, {-1, 0.02}, {8, 0});
    add_part(scene, segment({0, -1}, {0, 1})).sensor = true;
    const auto world = make_world(scene);
    std::vector<Event> seen;
    for (int i = 0; i < 30; ++i) {
        world->step(1.0 / 60);
        seen.insert(seen.end(), world->events().begin(), world->events().end());
    }
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[0].kind, EventKind::sensor_begin);
    EXPECT_NEAR(seen[0].time, 0.9 / 8, 1e-14);
    EXPECT_EQ(seen[1].kind, EventKind::sensor_end);
    EXPECT_NEAR(seen[1].time, 1.1 / 8, 1e-14);
}

TEST(Reference, GatesOpenOneWay) {
    for (const double way : {1.0, -1.0}) {
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        add_ball(scene, {-way, 0}, {way * 4, 0});
        add_part(scene, {shape::Gate{{0, -1}, {0, 1}, {1, 0}}});
        const auto world = make_world(scene);
        run(*world, 0.25);
        EXPECT_EQ(world->parts()[0].open, way > 0);
        run(*world, 0.75);
        EXPECT_FALSE(world->parts()[0].open);
        EXPECT_NEAR(world->balls()[0].position.x, way > 0 ? 3 : 0.1 + 4 - 0.9, 1e-12);
    }
}

TEST(Reference, RestsInAV) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_ball(scene, {0.1, 0.6});
    add_part(scene, {shape::Polyline{{{-2, 2}, {0, 0}, {2, 2}}, false}}, {"", 0.5, 0, 0});
    const auto world = make_world(scene);
    run(*world, 4);
    EXPECT_EQ(world->balls()[0].velocity, Vec2{});
    EXPECT_NEAR(world->balls()[0].position.y, 0.1 * std::sqrt(2.0), 1e-12);
}

// It rolls up and down both walls in turn, each time a third as fast, also when that is only rounding.
TEST(Reference, RollsIntoACornerAndRests) {
    for (const double drag : {0.0, 0.5, 20.0})
        for (const double friction : {1.2, 2.0, 50.0})
            for (const char* precision : {"53", "113"}) {
                Scene scene = empty_scene({3, -4});
                scene.damping = drag;
                scene.materials[0] = {"default", 0, friction, 0};
                add_ball(scene, {0.8, -0.84}, {1.8, 0.4}, 0.02).spin = 20;
                add_part(scene, {shape::Polyline{{{-1, -1}, {1, -1}, {1, 1}}, false}}, {"", 0, friction, 0});
                const auto world = make_world(scene, {{"precision", precision}});
                run(*world, 3);
                EXPECT_EQ(world->balls()[0].velocity, Vec2{});
                EXPECT_EQ(world->balls()[0].spin, 0);
                EXPECT_LT(length(world->balls()[0].position - Vec2{0.98, -0.98}), 1e-12);
            }
}

}  // namespace
}  // namespace flipside::reference::test
