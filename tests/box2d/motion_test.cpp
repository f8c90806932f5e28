#include <cstdio>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "box2d/table_top.hpp"

namespace flipside::box2d::test {
namespace {

using std::numbers::pi;

/// A left flipper at the origin, from −30° to 45° at 4 turns per second up.
TableTop with_flipper(double restitution) {
    TableTop top;
    Part& part = top.part(shape::Flipper{{0, 0}, 0.08, 0.012, 0.007, -pi / 6}, top.material(restitution));
    part.motion = motion::Flip{Side::left, pi / 4, 8 * pi, 4 * pi};
    return top;
}

TEST(Motion, flipperIsExactlyWhereTheTableSays) {
    TableTop top = with_flipper(0.5);
    top.part(shape::Segment{{1, 0}, {1.1, 0}}).motion = motion::Turn{{1, 0}, 2.5, true};
    const auto world = top.world();
    world->apply(control::Flip{Side::left, true});
    double angle = 0;
    for (int i = 1; i <= 10; ++i) {
        world->step(frame);
        angle = std::min(8 * pi * i * frame, pi / 6 + pi / 4);
        EXPECT_NEAR(world->parts()[0].angle, angle, 1e-14);
        EXPECT_NEAR(world->parts()[1].angle, 2.5 * i * frame, 1e-14);
        // A probe that touches the tip's top finds the surface there: single precision of the place.
        const Vec2 tip = 0.08 * from_angle(-pi / 6 + angle);
        const BallNumber probe = world->add([&] {
            Ball ball;
            ball.radius = radius;
            ball.mass = 0.08;
            ball.position = tip + (0.007 + 0.9 * radius) * from_angle(-pi / 6 + angle);
            return ball;
        }());
        ASSERT_EQ(world->contacts().size(), 1U);
        EXPECT_NEAR(world->contacts()[0].separation, -0.1 * radius, 1e-5 * radius);
        EXPECT_TRUE(world->remove(probe));
    }
}

TEST(Motion, flipperHitFollowsTheSurfaceSpeed) {
    // v' = −e·v + (1+e)·u, u = ω·x at the contact, 0.05 m from the pivot, within what the flipper turns
    // in one step (1/600 s, 2.4°) and the ball's approach by 3 slops.
    TableTop top = with_flipper(0.5);
    top.scene.gravity = {};
    std::get<motion::Flip>(top.scene.parts[0].motion).raised = pi / 2;
    const Vec2 normal = perp(from_angle(0));
    top.ball(Vec2{0.05, 0} + 0.0225 * normal, {0, 0});
    const auto world = top.world();
    world->apply(control::Flip{Side::left, true});
    Event hit{};
    for (int i = 0; i < 60 && hit.impulse == 0; ++i) {
        world->step(1.0 / 600);
        for (const Event& event : world->events())
            if (event.kind == EventKind::impact) hit = event;
    }
    ASSERT_GT(hit.impulse, 0);
    const double u = dot(cross(8 * pi, hit.point), hit.normal);
    EXPECT_NEAR(hit.speed, u, 0.02 * u);
    EXPECT_NEAR(hit.impulse, 0.08 * 1.5 * u, 0.02 * 0.08 * 1.5 * u);
    EXPECT_NEAR(dot(world->balls()[0].velocity, hit.normal), 1.5 * u, 0.05 * u);
}

TEST(Motion, turningWheelRunsOnlyWhileRotateIsOn) {
    TableTop top;
    top.part(shape::Segment{{0, 0}, {0.1, 0}}).motion = motion::Turn{{0, 0}, 3, false};
    const auto world = top.world();
    run(*world, 0.5);
    EXPECT_EQ(world->parts()[0].angle, 0);
    world->apply(control::Rotate{true});
    run(*world, 0.5);
    EXPECT_NEAR(world->parts()[0].angle, 1.5, 1e-12);
}

TEST(Motion, flightIsBox2dsOwnWithGravityAndDamping) {
    // v ← (v + h·g)/(1 + h·c), p ← p + h·v, in single precision: 42 roundings of about 1e-6 units.
    TableTop top;
    top.scene.damping = 0.4;
    top.ball({0, 1}, {0.5, 2});
    const auto world = top.world();
    run(*world, 0.7);
    Vec2 p{0, 1}, v{0.5, 2};
    for (int i = 0; i < 42; ++i) {
        v = (v + frame * Vec2{0, -9.81}) / (1 + frame * 0.4);
        p += frame * v;
    }
    EXPECT_NEAR(world->balls()[0].position.x, p.x, 5e-6);
    EXPECT_NEAR(world->balls()[0].position.y, p.y, 5e-6);
    EXPECT_NEAR(world->balls()[0].velocity.y, v.y, 5e-6);
}

TEST(Motion, verletFliesTheParabola) {
    // To the rounding of 252 sums in single precision; euler would be off by ½·g·h·t = 57 mm.
    TableTop top;
    top.ball({0, 1}, {0.5, 2});
    Settings settings(engine().settings);
    settings.set("integrator", "verlet");
    for (const int n : {1, 3}) {
        settings.set("substeps", n);
        const auto world = top.world(settings);
        run(*world, 0.7);
        const double t = 42 * frame;
        EXPECT_NEAR(world->balls()[0].position.x, 0.5 * t, 1e-5);
        EXPECT_NEAR(world->balls()[0].position.y, 1 + 2 * t - 0.5 * 9.81 * t * t, 1e-5);
        EXPECT_NEAR(world->balls()[0].velocity.y, 2 - 9.81 * t, 1e-5);
    }
}

TEST(Motion, verletLiesStillWithoutTremor) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}});
    top.ball({0, radius + 1e-3}, {}, top.material(0));
    Settings settings(engine().settings);
    settings.set("integrator", "verlet");
    settings.set("sleep", "off");
    const auto world = top.world(settings);
    run(*world, 1);
    const Vec2 rest = world->balls()[0].position;
    for (int i = 0; i < 60; ++i) {
        world->step(frame);
        EXPECT_NEAR(world->balls()[0].position.y, rest.y, 1e-6);
        EXPECT_NEAR(world->balls()[0].velocity.y, 0, 1e-6);
        EXPECT_TRUE(world->events().empty()) << i;
    }
}

TEST(Motion, box2dSlowsWhatMovesMoreThanTwoUnitsPerSubstep) {
    // Half a unit per ball diameter: four diameters per step are the most, 6.48 m/s at 1/60 s.
    TableTop top;
    top.scene.gravity = {};
    top.ball({-1, 0}, {10, 0});
    const auto one = top.world();
    one->step(frame);
    EXPECT_NEAR(one->balls()[0].velocity.x, 4 * 2 * radius / frame, 1e-5);
    Settings settings(engine().settings);
    settings.set("substeps", 2);
    const auto two = top.world(settings);
    two->step(frame);
    EXPECT_NEAR(two->balls()[0].velocity.x, 10, 1e-5);
}

TEST(Motion, substepsBringFlightCloserInProportion) {
    // Semi-implicit Euler is off by ½·g·h·t: 16.35 mm per 0.2 s at 1/60 s.
    TableTop top;
    top.ball({0, 1});
    Settings settings(engine().settings);
    for (const int n : {1, 4, 16}) {
        settings.set("substeps", n);
        const auto world = top.world(settings);
        run(*world, 0.4);
        EXPECT_NEAR(world->balls()[0].position.y, 1 - 0.5 * 9.81 * 0.16 - 0.5 * 9.81 * frame / n * 0.4, 1e-5);
        EXPECT_EQ(world->statistics().substeps, static_cast<std::uint64_t>(n));
    }
}

TEST(Motion, noFastBallIsLostThroughThinWalls) {
    TableTop top;
    top.scene.bounds = {{-0.3, -0.3}, {0.3, 0.3}};
    top.part(shape::Polyline{{{-0.25, -0.25}, {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}}, true});
    top.part(shape::Segment{{-0.1, 0.02}, {0.12, -0.03}});
    top.part(shape::Arc{{0.1, 0.1}, 0.05, 1, 4});
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> angle(0, 2 * pi);
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 8; ++column)
            top.ball({-0.2 + 0.05 * column, -0.2 + 0.08 * row}, 6.0 * from_angle(angle(random)));
    const auto world = top.world();
    int lost = 0;
    run(*world, 5, [&] { lost += count(world->events(), EventKind::lost); });
    EXPECT_EQ(lost, 0);
    for (const Ball& ball : world->balls()) {
        EXPECT_LT(std::abs(ball.position.x), 0.25);
        EXPECT_LT(std::abs(ball.position.y), 0.25);
    }
}

TEST(Motion, aBallOutOfBoundsIsLostOnce) {
    for (const bool keep : {false, true}) {
        TableTop top;
        top.scene.gravity = {};
        top.scene.keep_lost = keep;
        top.ball({0, 0});
        top.ball({1.9, 0}, {3, 0});
        const auto world = top.world();
        int lost = 0;
        run(*world, 1, [&] {
            for (const Event& event : world->events())
                if (event.kind == EventKind::lost && event.ball == 1) ++lost;
        });
        EXPECT_EQ(lost, 1);
        EXPECT_EQ(world->balls().size(), keep ? 2U : 1U);
    }
}

TEST(Motion, nudgeMovesAndWakesEveryBall) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0));
    top.ball({0, radius});
    const auto world = top.world();
    run(*world, 2);
    ASSERT_TRUE(world->balls()[0].asleep);
    world->apply(control::Nudge{{0.3, 0}});
    EXPECT_EQ(world->balls()[0].velocity, (Vec2{0.3, 0}));
    run(*world, 0.5);
    EXPECT_NEAR(world->balls()[0].position.x, 0.15, 1e-4);
}

TEST(Motion, launcherFiresNewBallsAndThoseThatLieThere) {
    TableTop top;
    top.scene.gravity = {};
    Launcher launcher;
    launcher.position = {0, -0.5};
    launcher.direction = {0, 1};
    launcher.slowest = 1;
    launcher.fastest = 3;
    launcher.plunger = true;
    launcher.ball = top.ball({0, -0.5});
    top.scene.launcher = launcher;
    const auto world = top.world();
    world->apply(control::Launch{0.5, 2, 1});
    run(*world, 0.5);
    ASSERT_EQ(world->balls().size(), 2U);
    EXPECT_NEAR(world->balls()[0].velocity.y, 2, 1e-6);
    EXPECT_NEAR(world->balls()[0].position.y, 0.5, 1e-5);
    EXPECT_EQ(world->balls()[1].number, 1U);
    EXPECT_NEAR(world->balls()[1].velocity.y, 2, 1e-6);
}

}  // namespace
}  // namespace flipside::box2d::test
