// Cases with known answers for the continuous solver: moving parts, gates, sensors.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

constexpr double pi = std::numbers::pi;

std::unique_ptr<World> continuous(const Scene& scene) {
    return make_world(scene, {{"solver", "continuous"}, {"sleep", "off"}});
}

Part& add_flipper(Scene& scene, double e, double rate, double raised = pi / 3) {
    Part& part = add_part(scene, {shape::Flipper{{0, 0}, 1, 0.15, 0.1, 0}}, {"", e, 0, 0});
    part.motion = motion::Flip{Side::left, raised, rate, rate};
    return part;
}

// 19: v' = −e·v + (1+e)·u with u the speed of the surface: base, middle, tip, receding, and at the stop.
TEST(HardCases, FlipperHitsAreExact) {
    for (const double e : {1.0, 0.6}) {
        for (const double x : {0.0, 0.5, 1.02}) {
            for (const bool up : {true, false}) {
                Scene scene = empty_scene();
                scene.rest_speed = 0;
                add_flipper(scene, e, 8);
                add_ball(scene, {x, 0.5}, {0, -20});
                const auto world = continuous(scene);
                if (up) world->apply(control::Flip{Side::left, true});
                world->step(1.0 / 30);
                ASSERT_GE(world->events().size(), 1U);
                const Event hit = world->events()[0];
                ASSERT_EQ(hit.kind, EventKind::impact);
                // The disc touches at the time of the event …
                const Vec2 center = Vec2{x, 0.5} + hit.time * Vec2{0, -20};
                EXPECT_NEAR(length(center - hit.point), 0.1, 1e-12);
                // … and leaves with the reflected speed.
                const double u = dot(cross(up ? 8.0 : 0.0, hit.point), hit.normal);
                const double v = dot(Vec2{0, -20}, hit.normal);
                EXPECT_NEAR(hit.speed, u - v, 1e-9);
                EXPECT_NEAR(dot(world->balls()[0].velocity, hit.normal), -e * v + (1 + e) * u, 1e-9);
            }
        }
    }
}

TEST(HardCases, FlipperStopsDead) {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    add_flipper(scene, 1, 100, pi / 2);  // at its stop after 15.7 ms
    add_ball(scene, {-0.4, 0.7}, {10, 0});
    const auto world = continuous(scene);
    world->apply(control::Flip{Side::left, true});
    world->step(1.0 / 30);
    ASSERT_EQ(world->events().size(), 1U);
    const Event& hit = world->events()[0];
    EXPECT_GT(hit.time, pi / 200);
    EXPECT_NEAR(hit.speed, dot(Vec2{-10, 0}, hit.normal), 1e-12);
    EXPECT_NEAR(length(world->balls()[0].velocity), 10, 1e-12);
}

TEST(HardCases, RecedingFlipperIsCaughtUp) {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    add_flipper(scene, 0.5, 3);
    const auto world = continuous(scene);
    world->apply(control::Flip{Side::left, true});
    world->step(1);  // raised
    world->apply(control::Flip{Side::left, false});
    Ball ball;
    ball.position = 0.6 * from_angle(pi / 3) + 0.4 * perp(from_angle(pi / 3));
    ball.velocity = -12 * perp(from_angle(pi / 3));
    ball.radius = 0.1;
    ball.mass = 1;
    world->add(ball);
    world->step(1.0 / 10);
    ASSERT_GE(world->events().size(), 1U);
    const Event& hit = world->events()[0];
    const double u = dot(cross(-3.0, hit.point), hit.normal), v = dot(ball.velocity, hit.normal);
    EXPECT_NEAR(hit.speed, u - v, 1e-9);
    EXPECT_NEAR(dot(world->balls()[0].velocity, hit.normal), -0.5 * v + 1.5 * u, 1e-9);
}

// 23: a fast ball begins and ends a sensor once, at the exact times.
TEST(HardCases, SensorIsCrossedOnce) {
    for (const double speed : {1.0, 50.0, 1e4}) {
        Scene scene = empty_scene();
        add_part(scene, segment({0, -1}, {0, 1})).sensor = true;
        add_part(scene, {shape::Circle{{2, 0}, 0.3}}).sensor = true;
        add_ball(scene, {-1, 0}, {speed, 0});
        const auto world = continuous(scene);
        std::vector<Event> events;
        const double dt = 1.0 / 60;
        while (world->time() < 4 / speed + dt) {
            world->step(dt);
            for (const Event& event : world->events())
                if (event.kind != EventKind::lost) events.push_back(event);
        }
        ASSERT_EQ(events.size(), 4U);
        const double exact[] = {0.9, 1.1, 2.6, 3.4};
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(events[i].kind, i % 2 == 0 ? EventKind::sensor_begin : EventKind::sensor_end);
            EXPECT_NEAR(events[i].time * speed, exact[i], 1e-9);
        }
    }
}

TEST(HardCases, GatePassesOneWay) {
    for (const bool along : {true, false}) {
        for (const double speed : {1.0, 500.0}) {
            Scene scene = empty_scene();
            scene.rest_speed = 0;
            add_part(scene, {shape::Gate{{0, -1}, {0, 1}, {along ? 1.0 : -1.0, 0}}});
            add_ball(scene, {-0.5, 0}, {speed, 0});
            const auto world = continuous(scene);
            bool was_open = false;
            while (world->time() < 1 / speed) {
                world->step(0.05 / speed);
                was_open = was_open || world->parts()[0].open;
            }
            EXPECT_EQ(was_open, along);
            EXPECT_FALSE(world->parts()[0].open);
            EXPECT_NEAR(world->balls()[0].velocity.x, along ? speed : -speed, 1e-12 * speed);
        }
    }
}

// 25: a ball that a flipper crushes against a wall stays.
TEST(HardCases, CrushedBallStays) {
    for (const double e : {1.0, 0.5, 0.0}) {
        Scene scene = empty_scene({0, -9.81});
        add_part(scene, {shape::Polyline{{{-1, -1}, {2, -1}, {2, 0.45}, {-1, 0.45}}, true}}, {"", e, 0, 0});
        add_flipper(scene, e, 20);
        add_ball(scene, {0.6, 0.3});
        const auto world = continuous(scene);
        for (int i = 0; i < 600; ++i) {
            if (i % 60 == 10) world->apply(control::Flip{Side::left, true});
            if (i % 60 == 40) world->apply(control::Flip{Side::left, false});
            world->step(1.0 / 60);
            const Ball& ball = world->balls()[0];
            ASSERT_TRUE(is_finite(ball.position) && is_finite(ball.velocity));
            ASSERT_TRUE((Box{{-1.05, -1.05}, {2.05, 0.5}}.contains(ball.position))) << "step " << i;
        }
    }
}

// A turning segment, 20 r long, 5…60 rad/s, against balls of 0…400 m/s: a ball never changes sides without
// going round an end. Followed in short steps in the segment's own frame.
TEST(HardCases, NothingPassesATurningSegment) {
    int hits = 0;
    for (int i = 0; i < 700; ++i) {
        const double rate = 5 + 55.0 * (i % 7) / 6, speed = 400.0 * (i % 100) / 99, around = 0.61 * i;
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        add_part(scene, segment({-1, 0}, {1, 0})).motion = motion::Turn{{0, 0}, rate, true};
        const Vec2 start = 1.5 * from_angle(around), aim = 0.8 * std::sin(1.7 * i) * from_angle(2.1 * i);
        add_ball(scene, start, speed * unit(aim - start));
        const auto world = continuous(scene);
        double before = 0;
        const double dt = 0.2 / (60 + 40 * std::max(rate, speed / 4));
        for (int k = 0; k < 300 && !world->balls().empty(); ++k) {
            world->step(dt);
            hits += static_cast<int>(world->statistics().impacts);
            const Vec2 p = rotated(world->balls()[0].position, -rate * world->time());
            EXPECT_GE(std::abs(p.x) <= 1 ? std::abs(p.y) : 1, 0.1 - 1e-9) << "placement " << i;
            if (std::abs(p.x) < 1 && before != 0) {
                ASSERT_GT(before * p.y, 0) << "placement " << i;
            }
            before = std::abs(p.x) < 1 ? p.y : 0;
        }
    }
    std::printf("turning segment: %d hits\n", hits);
    EXPECT_GT(hits, 400);
}

// A flipper raised at every phase of an incoming ball, at one step per frame.
TEST(HardCases, NothingPassesARaisedFlipper) {
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        Scene scene = empty_scene({0, -9.81});
        add_flipper(scene, 0.7, 40, pi / 3);
        const double x = 0.1 + 0.35 * (i % 37) / 36, speed = 1 + 60.0 * (i % 11) / 10;
        const double height = 0.3 + speed / 60 * 4 * (i / 1000.0);
        add_ball(scene, {x, height}, {0, -speed});
        const auto world = continuous(scene);
        bool hit = false;
        for (int k = 0; k < 30 && !hit; ++k) {
            if (k == 1) world->apply(control::Flip{Side::left, true});
            world->step(1.0 / 60);
            hit = world->statistics().impacts > 0;
            const Ball& ball = world->balls()[0];
            const Vec2 p = rotated(ball.position, -world->parts()[0].angle);
            if (ball.position.x > 0 && p.x > 0 && p.x < 0.9) {
                ASSERT_GT(p.y, 0.19) << "placement " << i;
            }
        }
        hits += hit;
    }
    std::printf("flipper: %d of 1000 hit\n", hits);
    EXPECT_EQ(hits, 1000);
}

}  // namespace
}  // namespace flipside::custom::test
