// Cases with known answers for the continuous solver; numbers and answers as in docs/accuracy. One ball.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double g = 9.81;

std::unique_ptr<World> continuous(const Scene& scene) {
    return make_world(scene, {{"solver", "continuous"}, {"sleep", "off"}});
}

Scene bouncing(double height, double restitution) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_ball(scene, {0, height + 0.1});
    add_part(scene, segment({-1, 0}, {1, 0}), {"", restitution, 0, 0});
    return scene;
}

// 1: impact n at speed eⁿ√(2gh); rest after √(2h/g)·(1+e)/(1−e).
TEST(HardCases, ZenoDropComesToRestInTime) {
    for (const double e : {0.5, 0.8, 0.9}) {
        const auto world = continuous(bouncing(1, e));
        const double fall = std::sqrt(2 / g), rest = fall * (1 + e) / (1 - e);
        double time = fall, speed = std::sqrt(2 * g), last = 0;
        while (world->time() < rest + 0.1) {
            world->step(1.0 / 60);
            for (const Event& event : world->events()) {
                if (event.kind != EventKind::impact) continue;
                last = event.time;
                if (speed > 1e-5) {
                    EXPECT_NEAR(event.time, time, 1e-9 * time);
                    EXPECT_NEAR(event.speed, speed, 1e-9 * speed);
                }
                speed *= e;
                time += 2 * speed / g;
            }
        }
        std::printf("e %.1f: last impact %.12f s, exact rest %.12f s\n", e, last, rest);
        EXPECT_NEAR(last, rest, 2e-8 * rest);
        EXPECT_EQ(world->balls()[0].velocity, Vec2{});
        EXPECT_NEAR(world->balls()[0].position.y, 0.1, 1e-15);
        EXPECT_EQ(world->statistics().handed_over, 0U);
    }
}

// 2: energy of 1e5 elastic bounces to 4Nε.
TEST(HardCases, ElasticDropKeepsItsEnergy) {
    const auto world = continuous(bouncing(0.05, 1));
    const double energy = g * 0.15;
    std::uint64_t bounces = 0;
    while (bounces < 100'000) {
        world->step(1.0 / 10);
        bounces += world->statistics().impacts;
    }
    const Ball& ball = world->balls()[0];
    const double drift = (length_squared(ball.velocity) / 2 + g * ball.position.y) / energy - 1;
    std::printf("%llu bounces: energy drift %.3e, allowed %.3e\n", static_cast<unsigned long long>(bounces),
                drift, 4 * 0x1p-53 * static_cast<double>(bounces));
    EXPECT_LE(std::abs(drift), 4 * 0x1p-53 * static_cast<double>(bounces));
}

Scene box(Vec2 gravity = {}) {
    Scene scene = empty_scene(gravity);
    scene.rest_speed = 0;
    add_part(scene, {shape::Polyline{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true}});
    return scene;
}

// 3: unfolded, each coordinate is a triangle wave.
TEST(HardCases, BoxIsTwoTriangleWaves) {
    Scene scene = box();
    add_ball(scene, {0.3, 0.4}, {71, 43}, 0.1);
    const auto world = continuous(scene);
    std::uint64_t hits = 0;
    const auto wave = [](double start, double way) {
        const double u = std::fmod(start - 0.1 + way, 1.6);
        return 0.1 + (u < 0.8 ? u : 1.6 - u);
    };
    while (hits < 1'000'000) {
        for (int i = 0; i < 100; ++i) {
            world->step(1.0);
            hits += world->statistics().impacts;
        }
    }
    const Ball& ball = world->balls()[0];
    const double error =
        length(ball.position - Vec2{wave(0.3, 71 * world->time()), wave(0.4, 43 * world->time())});
    std::printf("%llu hits: error %.2e\n", static_cast<unsigned long long>(hits), error);
    EXPECT_LE(error, 1e-9);
    EXPECT_DOUBLE_EQ(std::abs(ball.velocity.x), 71);
}

// 4: in a right-angled V each wall is a Zeno drop under g/√2; the ball then rests on both.
TEST(HardCases, RightAngledVBringsToRest) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_ball(scene, {0.1, 0.6});
    add_part(scene, {shape::Polyline{{{-2, 2}, {0, 0}, {2, 2}}, false}}, {"", 0.5, 0, 0});
    const auto world = continuous(scene);
    const double a = g / std::sqrt(2.0), e = 0.5;
    // Heights over the right wall (normal (−1,1)/√2) and the left one.
    const double height[] = {(-0.1 + 0.6) / std::sqrt(2.0) - 0.1, (0.1 + 0.6) / std::sqrt(2.0) - 0.1};
    double rest = 0;
    for (const double h : height) rest = std::max(rest, std::sqrt(2 * h / a) * (1 + e) / (1 - e));
    double last = 0;
    while (world->time() < rest + 0.1) {
        world->step(1.0 / 60);
        for (const Event& event : world->events())
            if (event.kind == EventKind::impact) last = event.time;
    }
    std::printf("V: last impact %.12f s, exact rest %.12f s\n", last, rest);
    EXPECT_NEAR(last, rest, 2e-8 * rest);
    EXPECT_EQ(world->balls()[0].velocity, Vec2{});
    EXPECT_NEAR(world->balls()[0].position.y, 0.1 * std::sqrt(2.0), 1e-12);
    EXPECT_EQ(world->contacts().size(), 1U);  // one part, the deeper of its two faces
    EXPECT_EQ(world->statistics().handed_over, 0U);
}

// 11: the hit angle advances by π − 2α each time.
TEST(HardCases, CircularBilliardAdvancesEvenly) {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    add_part(scene, {shape::Arc{{0, 0}, 1, 0, 2 * pi}});
    const double alpha = 0.7, inner = 0.9;
    add_ball(scene, {inner, 0}, 50 * from_angle(pi - alpha), 0.1);
    const auto world = continuous(scene);
    std::uint64_t hits = 0;
    double worst = 0, angle = 0;
    while (hits < 1'000'000) {
        world->step(1.0);
        for (const Event& event : world->events()) {
            if (event.kind != EventKind::impact) continue;
            ++hits;
            angle = std::remainder(pi - 2 * alpha, 2 * pi) * static_cast<double>(hits);
            const double error = std::abs(std::remainder(angle_of(event.point) - angle, 2 * pi));
            worst = std::max(worst, error / static_cast<double>(hits));
        }
    }
    std::printf("%llu hits: angle error per hit %.2e\n", static_cast<unsigned long long>(hits), worst);
    EXPECT_LE(worst, 2e-11);
    EXPECT_NEAR(length(world->balls()[0].velocity), 50, 1e-9);
}

// 12: a frictionless ball in a bowl is a pendulum.
TEST(HardCases, BowlHasThePendulumsPeriod) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    const double start = pi / 3;
    add_part(scene, {shape::Arc{{0, 0}, 1.1, pi, 2 * pi}});
    add_ball(scene, from_angle(-pi / 2 + start), {}, 0.1);
    const auto world = continuous(scene);
    // The tenth time that it swings through the lowest point to the left ends after 9 periods and a quarter.
    double time = 0;
    int passes = 0;
    const double dt = 1.0 / 60;
    Ball before;
    while (passes < 10) {
        before = world->balls()[0];
        world->step(dt);
        const Ball& ball = world->balls()[0];
        if (before.position.x > 0 && ball.position.x <= 0) {
            ++passes;
            // Newton on a world of its own from the saved state.
            double t = dt * before.position.x / (before.position.x - ball.position.x);
            for (int i = 0; i < 4; ++i) {
                const auto probe = continuous(scene);
                State state = world->save();
                state.balls = {before};
                probe->restore(state);
                probe->step(t);
                t -= probe->balls()[0].position.x / probe->balls()[0].velocity.x;
            }
            time = world->time() - dt + t;
        }
    }
    double a = 1, b = std::cos(start / 2);
    for (int i = 0; i < 8; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    const double period = 2 * pi * std::sqrt(1 / g) / a;
    EXPECT_NEAR(period, 2.152875, 1e-6);
    std::printf("period %.12f s, exact %.12f s\n", time / 9.25, period);
    EXPECT_NEAR(time / 9.25, period, 1e-11);
    EXPECT_EQ(world->statistics().impacts, 0U);
}

// 13: sliding off the top of a circle it leaves at cos θ = 2/3.
TEST(HardCases, LeavesTheCircleAtTwoThirds) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_part(scene, {shape::Circle{{0, 0}, 0.9}});
    const double start = 0.01;
    add_ball(scene, Vec2{std::sin(start), std::cos(start)}, {}, 0.1);
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 1000}) {
        const auto world = continuous(scene);
        while (world->balls()[0].position.y > 0) world->step(dt);
        // In flight: back to where it left the circle of radius 1.
        const Ball& ball = world->balls()[0];
        const double cosine = 2.0 / 3 * std::cos(start), speed = std::sqrt(g * cosine);
        const double sine = std::sqrt(1 - cosine * cosine);
        const double vx = speed * cosine;
        EXPECT_NEAR(ball.velocity.x, vx, 1e-9 * vx);
        const double t = (ball.position.x - sine) / vx;
        EXPECT_NEAR(ball.position.y, cosine - speed * sine * t - g * t * t / 2, 1e-9);
        std::printf("dt %.4f: leaves at cos θ − 2/3·cos θ₀ = %.2e\n", dt,
                    std::cbrt(ball.velocity.x * ball.velocity.x / g) - cosine);
    }
}

// 15: a graze of depth δ deflects by 2·acos(1 − δ); a miss does not.
TEST(HardCases, GrazesOrMisses) {
    for (const double delta : {1e-3, 1e-6, 1e-9, 1e-12, -1e-12, -1e-9}) {
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        add_part(scene, {shape::Circle{{0, 0}, 0.4}});
        add_ball(scene, {-2, 0.5 * (1 - delta)}, {3, 0}, 0.1);
        const auto world = continuous(scene);
        run(*world, 2);
        const double deflection = angle_of(world->balls()[0].velocity);
        if (delta < 0) {
            EXPECT_EQ(deflection, 0);
            continue;
        }
        const double exact = 2 * std::acos(1 - delta);
        std::printf("δ %.0e: deflected by %.9e, exact %.9e\n", delta, deflection, exact);
        EXPECT_NEAR(deflection, exact, exact * (1e-12 + 8 * 0x1p-53 / delta));
    }
}

// 16: nothing to feel on a floor of 1e4 collinear segments, lying flat or turned.
TEST(HardCases, CollinearSegmentsAreSmooth) {
    for (const double angle : {0.0, 0.3}) {
        const Vec2 along = from_angle(angle);
        for (const double weight : {g, 0.0}) {
            Scene scene = empty_scene(weight * -perp(along));
            scene.bounds = {{-1000, -1000}, {1000, 1000}};
            shape::Polyline floor;
            for (int i = 0; i <= 10'000; ++i) floor.points.push_back(0.01 * i * along);
            add_part(scene, {floor}, {"", 0.5, 0, 0});
            add_ball(scene, 0.05 * along + 0.1 * perp(along), 5 * along);
            const auto world = continuous(scene);
            std::uint64_t impacts = 0;
            for (int i = 0; i < 19 * 60; ++i) {
                world->step(1.0 / 60);
                impacts += world->statistics().impacts;
            }
            const Ball& ball = world->balls()[0];
            EXPECT_EQ(impacts, 0U);
            // The corners of a turned floor are rounded: its segments slope by up to 1e-14.
            EXPECT_NEAR(dot(ball.velocity, along), 5, 1e-11);
            EXPECT_NEAR(dot(ball.position, along), 95.05, 1e-9);
            EXPECT_NEAR(dot(ball.position, perp(along)), 0.1, 1e-10);
        }
    }
}

// 17: a wall without thickness holds at a million radii per second.
TEST(HardCases, ThinWallHoldsAtAnySpeed) {
    for (const double speed : {1.0, 1e3, 1e5}) {
        for (const double angle : {0.0, 0.4, 1.0}) {
            Scene scene = empty_scene();
            scene.rest_speed = 0;
            add_part(scene, segment({0, -50}, {0, 50}));
            add_ball(scene, {-1, 0}, speed * from_angle(angle));
            const auto world = continuous(scene);
            const double vx = speed * std::cos(angle), exact = 0.9 / vx;
            double hit = 0;
            for (int i = 0; i < 200 && hit == 0; ++i) {
                world->step(1.0 / 60);
                if (!world->events().empty()) hit = world->events()[0].time;
            }
            EXPECT_NEAR(hit, exact, 1e-12 * exact);
            EXPECT_NEAR(world->balls().empty() ? -vx : world->balls()[0].velocity.x, -vx, 1e-12 * vx);
        }
    }
}

// 18: far from the origin errors are of the origin's ulp.
TEST(HardCases, FarFromTheOrigin) {
    for (const double far : {1e2, 1e4, 1e6}) {
        const Vec2 origin{far, -far};
        Scene scene = empty_scene({0, -g});
        scene.rest_speed = 0;
        scene.bounds = {{-1e9, -1e9}, {1e9, 1e9}};
        add_ball(scene, origin + Vec2{0, 1.1});
        add_part(scene, segment(origin - Vec2{1, 0}, origin + Vec2{1, 0}), {"", 0.8, 0, 0});
        const auto world = continuous(scene);
        const double first = std::sqrt(2 / g), second = first * (1 + 2 * 0.8);
        std::vector<double> times;
        for (int i = 0; i < 80; ++i) {
            world->step(1.0 / 60);
            for (const Event& event : world->events()) times.push_back(event.time);
        }
        const double ulp = far * 0x1p-52;
        ASSERT_GE(times.size(), 2U);
        EXPECT_NEAR(times[0], first, 40 * ulp);
        EXPECT_NEAR(times[1], second, 40 * ulp);
        const double t = world->time() - second, v = 0.64 * std::sqrt(2 * g);
        EXPECT_NEAR(world->balls()[0].position.y - origin.y, 0.1 + v * t - g * t * t / 2, 200 * ulp);
    }
}

// 21: what starts deeply overlapped comes out without a gain of energy.
TEST(HardCases, DeepOverlapGainsNoEnergy) {
    for (const double depth : {0.01, 0.1, 0.15}) {
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        add_part(scene, {shape::Polygon{{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}}}});
        add_ball(scene, {0.2, 0.1 - depth}, {1, -2});
        const auto world = continuous(scene);
        run(*world, 0.5);
        const Ball& ball = world->balls()[0];
        EXPECT_NEAR(length_squared(ball.velocity), 5, 1e-12);
        EXPECT_GT(ball.velocity.y, 0);
        EXPECT_GT(ball.position.y, 0.1);
    }
}

}  // namespace
}  // namespace flipside::custom::test
