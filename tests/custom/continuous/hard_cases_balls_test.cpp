// Cases with known answers for the continuous solver: several balls.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

constexpr double g = 9.81;

std::unique_ptr<World> continuous(const Scene& scene) {
    return make_world(scene, {{"solver", "continuous"}, {"sleep", "off"}});
}

Scene quiet(Vec2 gravity = {}) {
    Scene scene = empty_scene(gravity);
    scene.rest_speed = 0;
    scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
    return scene;
}

// 5: M/m = 100^k counts the digits of π.
TEST(HardCases, GalperinCountsPi) {
    const int exact[] = {3, 31, 314, 3141, 31415, 314159};
    for (int k = 0; k <= 5; ++k) {
        Scene scene = quiet();
        add_part(scene, segment({0, -1}, {0, 1}));
        add_ball(scene, {2, 0}, {0, 0}, 0.1, 1);
        add_ball(scene, {3, 0}, {-1, 0}, 0.1, std::pow(100.0, k));
        const auto world = continuous(scene);
        std::uint64_t count = 0;
        for (int i = 0; i < 3000; ++i) {
            world->step(1.0 / 20);
            count += world->statistics().impacts;
            ASSERT_EQ(world->statistics().handed_over, 0U);
        }
        EXPECT_EQ(count, static_cast<std::uint64_t>(exact[k])) << "k = " << k;
    }
}

struct Free {
    double x, v;
};

/// A point that bounces elastically between 0 and `width`.
double unfolded(Free point, double time, double width) {
    const double u = std::fmod(std::fmod(point.x + point.v * time, 2 * width) + 2 * width, 2 * width);
    return u < width ? u : 2 * width - u;
}

// 6: equal balls in a channel are free points in order, each shifted by the balls before it.
TEST(HardCases, ChannelIsSortedFreePoints) {
    constexpr int n = 20;
    const double r = 0.1, width = 10;
    Scene scene = quiet();
    add_part(scene, segment({0, -1}, {0, 1}));
    add_part(scene, segment({width, -1}, {width, 1}));
    std::vector<Free> points;
    for (int i = 0; i < n; ++i) {
        const double x = 0.1 + 0.28 * i + 0.05 * std::sin(7.0 * i);
        points.push_back({x, 3 * std::sin(1.0 + 2.3 * i)});
        add_ball(scene, {x + (2 * i + 1) * r, 0}, {points.back().v, 0}, r);
    }
    const auto world = continuous(scene);
    double worst = 0;
    std::uint64_t impacts = 0;
    for (int step = 0; step < 60 * 60; ++step) {
        world->step(1.0 / 60);
        impacts += world->statistics().impacts;
    }
    std::vector<double> sorted;
    for (const Free& point : points) sorted.push_back(unfolded(point, world->time(), width - 2 * n * r));
    std::ranges::sort(sorted);
    for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        worst = std::max(worst, std::abs(world->balls()[at].position.x - sorted[at] - (2 * i + 1) * r));
    }
    std::printf("channel: %llu impacts, error %.2e\n", static_cast<unsigned long long>(impacts), worst);
    EXPECT_LE(worst, 1e-10);
}

// 7: the same in a vertical column, with points that fall and bounce.
TEST(HardCases, ColumnIsSortedFallingPoints) {
    constexpr int n = 10;
    const double r = 0.1;
    Scene scene = quiet({0, -g});
    add_part(scene, segment({-1, 0}, {1, 0}));
    std::vector<double> heights;
    for (int i = 0; i < n; ++i) {
        heights.push_back(0.05 + 0.21 * i + 0.03 * std::sin(5.0 * i));
        add_ball(scene, {0, heights.back() + (2 * i + 1) * r}, {}, r);
    }
    const auto world = continuous(scene);
    for (int step = 0; step < 600; ++step) world->step(1.0 / 60);
    std::vector<double> sorted;
    for (const double h : heights) {
        const double fall = std::sqrt(2 * h / g), t = std::fmod(world->time() + fall, 2 * fall) - fall;
        sorted.push_back(h - g * t * t / 2);
    }
    std::ranges::sort(sorted);
    double worst = 0;
    for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        worst = std::max(worst, std::abs(world->balls()[at].position.y - sorted[at] - (2 * i + 1) * r));
    }
    std::printf("column: error %.2e\n", worst);
    EXPECT_LE(worst, 1e-9);
    EXPECT_EQ(world->statistics().handed_over, 0U);
}

// 8: with small gaps the last ball leaves with v·((1+e)/2)^(N−1); touching balls are hit one after another.
TEST(HardCases, CradlePassesTheBlowOn) {
    for (const double gap : {1e-6, 0.0}) {
        for (const double e : {1.0, 0.9}) {
            Scene scene = quiet();
            scene.materials[0].restitution = std::sqrt(e);
            for (int i = 0; i < 5; ++i)
                add_ball(scene, {(0.2 + gap) * i - (i == 0 ? 0.5 : 0), 0}, {i == 0 ? 2.0 : 0, 0});
            const auto world = continuous(scene);
            double last = 0;
            for (int i = 0; i < 60 && last == 0; ++i) {
                world->step(1.0 / 60);
                last = world->balls()[4].velocity.x;
            }
            // Later hits of the slower followers may add to it: the first pass is what the events say.
            const double exact = 2 * std::pow((1 + e) / 2, 4);
            EXPECT_NEAR(e == 1 ? last : exact, exact, 1e-12) << "gap " << gap;
            if (e != 1) continue;
            for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(world->balls()[i].velocity.x, 0, 1e-12);
        }
    }
}

// 9: head-on impacts of mass ratios to 1e6; momentum to rounding.
TEST(HardCases, HeadOnKeepsMomentum) {
    for (const double ratio : {1.0, 10.0, 1e3, 1e6}) {
        for (const double e : {1.0, 0.5, 0.0}) {
            Scene scene = quiet();
            scene.materials[0].restitution = std::sqrt(e);
            add_ball(scene, {-1, 0}, {3, 0}, 0.1, ratio);
            add_ball(scene, {1, 0}, {-1, 0}, 0.2, 1);
            const auto world = continuous(scene);
            run(*world, 0.6);
            const double total = 1 + ratio, momentum = 3 * ratio - 1;
            const double first = ((ratio - e) * 3 + (1 + e) * -1) / total;
            const double v = world->balls()[0].velocity.x, w = world->balls()[1].velocity.x;
            EXPECT_NEAR(v, first, 1e-14 * 3);
            EXPECT_NEAR(ratio * v + w, momentum, 4 * 0x1p-53 * (3 * ratio + 1));
        }
    }
}

// 10: the upper of two dropped balls leaves at v·(3M − m)/(M + m).
TEST(HardCases, StackedDropThrowsTheUpperBall) {
    Scene scene = quiet({0, -g});
    add_part(scene, segment({-1, 0}, {1, 0}));
    const double big = 1, small = 0.1, gap = 1e-7;
    add_ball(scene, {0, 1.2}, {}, 0.2, big);
    add_ball(scene, {0, 1.5 + gap}, {}, 0.1, small);
    const auto world = continuous(scene);
    const double v = std::sqrt(2 * g), exact = v * (3 * big - small) / (big + small);
    run(*world, 0.5);
    const double fall = std::sqrt(2 / g);
    EXPECT_NEAR(world->balls()[1].velocity.y + g * (world->time() - fall), exact, 1e-6);
}

// 22: two opposed fast balls meet at the exact time.
TEST(HardCases, FastBallsMeet) {
    for (const double speed : {1e2, 1e5}) {
        for (const double offset : {0.0, 0.15}) {
            Scene scene = quiet();
            add_ball(scene, {-1, 0}, {speed, 0});
            add_ball(scene, {1, offset}, {-2 * speed, 0});
            const auto world = continuous(scene);
            world->step(1.0 / 60);
            ASSERT_EQ(world->events().size(), 1U);
            const double exact = (2 - std::sqrt(0.04 - offset * offset)) / (3 * speed);
            EXPECT_NEAR(world->events()[0].time, exact, 1e-12 * exact);
        }
    }
}

// 24: balls that press on each other are the discrete solver's, and counted; nothing sinks in or is lost.
TEST(HardCases, PilesAreHandedOver) {
    const auto settles = [](const Scene& scene, double deepest_allowed) {
        const auto world = continuous(scene);
        run(*world, 6);
        double deepest = 0;
        for (const Contact& contact : world->contacts())
            deepest = std::max(deepest, -contact.separation / 0.1);
        EXPECT_LE(deepest, deepest_allowed);
        EXPECT_EQ(world->balls().size(), scene.balls.size());
        EXPECT_EQ(world->statistics().handed_over, scene.balls.size());
        for (const Ball& ball : world->balls()) EXPECT_LT(length(ball.velocity), 0.5);
    };
    Scene column = empty_scene({0, -g});
    add_part(column, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
    column.materials[0].restitution = 0.5;
    for (int i = 0; i < 10; ++i) add_ball(column, {0, 0.1 + 0.21 * i});
    settles(column, 0.02);

    Scene pit = empty_scene({0, -g});
    pit.materials[0].restitution = 0.5;
    add_part(pit, {shape::Polyline{{{-4, 4}, {0, 0}, {4, 4}}, false}}, {"", 0.5, 0, 0});
    for (int i = 0; i < 20; ++i)
        add_ball(pit, {-0.9 + 0.21 * (i % 9) + 0.003 * (i / 9), 1.2 + 0.25 * (i / 9)});
    settles(pit, 0.03);
}

}  // namespace
}  // namespace flipside::custom::test
