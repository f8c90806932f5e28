// The continuous solver against known answers for a few balls, and for heaps that come to rest.

#include <numbers>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

double energy(const World& world, const Scene& scene) {
    double sum = 0;
    for (const Ball& ball : world.balls())
        sum += 0.5 * ball.mass * length_squared(ball.velocity) + 0.5 * inertia(ball) * ball.spin * ball.spin -
               ball.mass * dot(scene.gravity, ball.position);
    return sum;
}

TEST(KnownAnswers, ElasticBoxKeepsItsEnergy) {
    Scene scene = empty_scene();
    for (int i = 0; i < 30; ++i)
        add_ball(scene, {0.25 * (i % 6), 0.25 * (i / 6)}, {std::sin(3.0 * i), std::cos(5.0 * i)}, 0.08,
                 1 + i % 4);
    add_part(scene, {shape::Polyline{{{-0.5, -0.5}, {2, -0.5}, {2, 2}, {-0.5, 2}}, true}});
    const auto world = make_world(scene);
    const double before = energy(*world, scene);
    std::uint64_t impacts = 0;
    for (int i = 0; i < 600; ++i) world->step(1.0 / 60), impacts += world->statistics().impacts;
    EXPECT_GT(impacts, 500U);
    EXPECT_NEAR(energy(*world, scene), before, 1e-13 * before);
}

TEST(KnownAnswers, ElasticDropKeepsItsEnergyForAThousandBounces) {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 1.1});
    add_part(scene, segment({-1, 0}, {1, 0}));
    const auto world = make_world(scene);
    const double before = energy(*world, scene) - 9.81 * 0.1;
    run(*world, 900);  // period 2·√(2h/g) = 0.903 s
    EXPECT_NEAR(energy(*world, scene) - 9.81 * 0.1, before, 1e-9 * before);
}

TEST(KnownAnswers, CradlePassesTheVelocityOn) {
    for (const double e : {1.0, 0.8})
        for (const double gap : {1e-3, 1e-6}) {
            Scene scene = empty_scene();
            scene.materials[0].restitution = std::sqrt(e);
            add_ball(scene, {-0.5, 0}, {1, 0});
            for (int i = 1; i < 5; ++i) add_ball(scene, {i * (0.2 + gap), 0});
            const auto world = make_world(scene);
            run(*world, 1);
            EXPECT_NEAR(world->balls()[4].velocity.x, std::pow((1 + e) / 2, 4), 1e-12) << e << " " << gap;
            double momentum = 0;
            for (const Ball& ball : world->balls()) momentum += ball.velocity.x;
            EXPECT_NEAR(momentum, 1, 1e-14);
        }
}

TEST(KnownAnswers, ObliquePairIsExactWhateverTheStep) {
    // Impact parameter 0.12, sum of radii 0.2: the line of centres at the impact has sine 0.6.
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 997}) {
        Scene scene = empty_scene({0, -9.81});
        add_ball(scene, {0, 0.12}, {1, 0});
        add_ball(scene, {0.7, 0}, {0, 0});
        const auto world = make_world(scene);
        run(*world, 0.8, dt);
        const double fallen = 9.81 * world->time();
        EXPECT_NEAR(world->balls()[1].velocity.x, 0.64, 1e-12);
        EXPECT_NEAR(world->balls()[1].velocity.y + fallen, -0.48, 1e-11);
        EXPECT_NEAR(world->balls()[0].velocity.x, 0.36, 1e-12);
        // The impact was at x = 0.7 − 0.16, at 0.54 s.
        EXPECT_NEAR(world->balls()[1].position.x, 0.7 + 0.64 * (world->time() - 0.54), 1e-12);
    }
}

TEST(KnownAnswers, InclineSlidesOrRolls) {
    const double slope = 0.2;
    for (const double mu : {0.0, 0.5}) {
        Scene scene = empty_scene({0, -9.81});
        const Vec2 down = from_angle(-slope);
        scene.materials[0].friction = mu;
        add_ball(scene, 0.1 * perp(down));
        add_part(scene, segment(-1 * down, 20 * down), {"", 0.5, mu, 0});
        const auto world = make_world(scene);
        run(*world, 1);
        const double pull = 9.81 * std::sin(slope) * (mu > 0 ? 2.0 / 3 : 1);
        const Ball& ball = world->balls()[0];
        EXPECT_NEAR(dot(ball.velocity, down), pull, 1e-9);
        EXPECT_NEAR(dot(ball.position, down), pull / 2, 1e-9);
        EXPECT_NEAR(ball.spin, mu > 0 ? -pull / 0.1 : 0, 1e-7);
    }
}

TEST(KnownAnswers, SlidingTurnsToRollingAtTwoThirds) {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].friction = 0.2;
    add_ball(scene, {0, 0.1}, {3, 0});
    add_part(scene, segment({-1, 0}, {20, 0}), {"", 0.5, 0.2, 0});
    const auto world = make_world(scene);
    // Friction µ·g slows it for v/(3µg) = 0.51 s.
    run(*world, 0.25);
    EXPECT_NEAR(world->balls()[0].velocity.x, 3 - 0.2 * 9.81 * 0.25, 1e-9);
    run(*world, 0.75);
    EXPECT_NEAR(world->balls()[0].velocity.x, 2, 1e-9);
}

TEST(KnownAnswers, CollinearSegmentsGiveNoBump) {
    Scene scene = empty_scene({0, -9.81});
    shape::Polyline floor;
    for (int i = 0; i <= 400; ++i) floor.points.push_back({0.05 * i - 1, 0});
    add_part(scene, {floor}, {"", 0.9, 0, 0});
    for (const double speed : {0.5, 6.0}) {
        scene.balls.clear();
        add_ball(scene, {0, 0.0135}, {speed, 0}, 0.0135, 0.08);
        const auto world = make_world(scene);
        for (int i = 0; i < 120; ++i) {
            world->step(1.0 / 60);
            ASSERT_EQ(world->statistics().impacts, 0U) << speed << " step " << i;
        }
        EXPECT_NEAR(world->balls()[0].velocity.x, speed, 1e-12);
    }
}

TEST(KnownAnswers, BowlSwingsWithItsPeriod) {
    // L = R − r = 1, from 60°: T = 2.152875 s without friction.
    Scene scene = empty_scene({0, -9.81});
    const double from = std::numbers::pi / 3;
    add_ball(scene, {std::sin(from), -std::cos(from)});
    add_part(scene, {shape::Arc{{0, 0}, 1.1, std::numbers::pi, 2 * std::numbers::pi}}, {"", 0.5, 0, 0});
    const auto world = make_world(scene);
    const double before = energy(*world, scene);
    std::vector<double> turns;  // times of the turning points on the right
    for (int i = 0; i < 60 * 22; ++i) {
        const double v0 = world->balls()[0].velocity.x;
        world->step(1.0 / 60);
        const Ball& ball = world->balls()[0];
        if (ball.position.x > 0 && v0 > 0 && ball.velocity.x <= 0)
            turns.push_back(world->time() - ball.velocity.x / (ball.velocity.x - v0) / 60);
    }
    ASSERT_EQ(turns.size(), 10U);
    const double period = (turns.back() - turns.front()) / 9;
    std::printf("bowl: period %.6f s, exact 2.152875 s; energy %.2e of its swing in 22 s\n", period,
                (energy(*world, scene) - before) / (0.5 * 9.81));
    EXPECT_NEAR(period, 2.152875, 1e-4);
    EXPECT_NEAR(energy(*world, scene), before, 1e-9 * 9.81);
}

// A ball that rolls through a bowl turns by the length of its path over its radius. Its spin is no linear
// function of time.
TEST(KnownAnswers, ARollingBallTurnsByItsPath) {
    const double bowl = 1, radius = 0.1, start = -2.2;
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].friction = 5;
    add_part(scene, {shape::Arc{{0, 0}, bowl, -std::numbers::pi, 0}}, {"", 0, 5, 0});
    add_ball(scene, (bowl - radius) * from_angle(start), {}, radius);
    const auto world = make_world(scene, {{"sleep", "off"}});
    for (int step = 0; step < 60; ++step) {
        world->step(1.0 / 60);
        const Ball& ball = world->balls()[0];
        const double along = std::atan2(ball.position.y, ball.position.x) - start;
        EXPECT_NEAR(ball.angle, -along * (bowl - radius) / radius, 1e-9) << step;
    }
}

TEST(KnownAnswers, ThinWallStopsAnySpeed) {
    for (const double speed : {1.0, 10.0, 100.0, 1e4, 1e5}) {
        Scene scene = empty_scene();
        scene.bounds = {{-1e9, -1e9}, {1e9, 1e9}};
        add_ball(scene, {-0.53, 0}, {speed, 0});
        add_part(scene, segment({0, -1}, {0, 1}));
        const auto world = make_world(scene);
        run(*world, 1);
        EXPECT_NEAR(world->balls()[0].velocity.x, -speed, 1e-9 * speed) << speed;
        EXPECT_LT(world->balls()[0].position.x, 0) << speed;
    }
}

TEST(KnownAnswers, TurningPartHitsWithItsSurfaceVelocity) {
    // A bar hits a ball at rest 1 m from the pivot: v' = (1+e)·u along the normal at the impact.
    for (const double rate : {2.0, 20.0}) {
        Scene scene = empty_scene();
        add_ball(scene, {1, 0.3});
        add_part(scene, segment({0, 0}, {1.2, 0}), {"", 0.5, 0, 0}).motion = motion::Turn{{0, 0}, rate, true};
        const auto world = make_world(scene);
        run(*world, 0.25);
        // At the impact the centre of the ball is one radius from the bar.
        const double distance = std::hypot(1, 0.3);
        const double angle = std::atan2(0.3, 1) - std::asin(0.1 / distance);
        const double reach = std::sqrt(distance * distance - 0.01);
        const Vec2 expected = 1.5 * rate * reach * perp(from_angle(angle));
        EXPECT_LT(length(world->balls()[0].velocity - expected), 1e-12 * length(expected)) << rate;
    }
}

TEST(KnownAnswers, FlipperThrowsAndNothingPassesIt) {
    // For every phase of an incoming ball: it must end above the flipper or have rolled off its tip.
    for (int phase = 0; phase < 200; ++phase) {
        Scene scene = empty_scene({0, -1.11});
        add_ball(scene, {0.05, 0.2}, {0, -2.5}, 0.0135, 0.08);
        add_part(scene, {shape::Flipper{{0, 0}, 0.07, 0.01, 0.0065, -0.5}}, {"", 0.7, 0.1, 0}).motion =
            motion::Flip{Side::left, 0.6, 30, 15};
        const auto world = make_world(scene);
        run(*world, 0.03 + 0.0005 * phase, 0.0005);
        world->apply(control::Flip{Side::left, true});
        run(*world, 0.15);
        const Ball& ball = world->balls()[0];
        const Vec2 tip = 0.07 * from_angle(0.6);
        const bool below = cross(tip, ball.position) < 0 && ball.position.x > 0 && ball.position.x < 0.04;
        EXPECT_FALSE(below) << "phase " << phase << " at " << ball.position.x << ", " << ball.position.y;
        EXPECT_LT(length(ball.velocity), 8);
    }
}

TEST(KnownAnswers, KickedBallMeetsWallsBeyondItsFormerReach) {
    // The ball arrives at 1 m/s and is kicked to 200 m/s between two walls 2 m apart.
    Scene scene = empty_scene();
    add_ball(scene, {0, -0.5}, {0, -1});
    add_part(scene, segment({-9, -1}, {9, -1}), {"", 1, 0, 200});
    add_part(scene, segment({-9, 1}, {9, 1}), {"", 1, 0, 0});
    const auto world = make_world(scene);
    run(*world, 3);
    EXPECT_EQ(std::abs(world->balls()[0].velocity.y), 200);
    EXPECT_LT(std::abs(world->balls()[0].position.y), 0.9 + 1e-12);
}

TEST(KnownAnswers, DeepOverlapGainsNoSpeed) {
    Scene scene = empty_scene();
    add_ball(scene, {0, 0.02});
    add_ball(scene, {0.05, 0.03});
    add_part(scene, segment({-1, 0}, {1, 0}));
    add_part(scene, {shape::Circle{{0.3, 0.1}, 0.2}});
    const auto world = make_world(scene);
    run(*world, 1);
    for (const Ball& ball : world->balls()) EXPECT_EQ(ball.velocity, Vec2{});
    for (const Contact& contact : world->contacts()) EXPECT_GT(contact.separation, -1e-3);
}

TEST(KnownAnswers, BallInAVComesToRest) {
    Scene scene = empty_scene({0, -9.81});
    const double s = std::sqrt(0.5);
    add_ball(scene, {0, 1.2});
    add_part(scene, segment({-2, 2}, {0, 0}), {"", 0.7, 0, 0});
    add_part(scene, segment({0, 0}, {2, 2}), {"", 0.7, 0, 0});
    const auto world = make_world(scene);
    run(*world, 6);
    EXPECT_NEAR(world->balls()[0].position.x, 0, 1e-6);
    EXPECT_NEAR(world->balls()[0].position.y, 0.1 / s, 1e-6);
    EXPECT_TRUE(world->balls()[0].asleep);
}

TEST(KnownAnswers, ColumnOfThreeComesToRest) {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0.5;
    for (int i = 0; i < 3; ++i) add_ball(scene, {0, 0.1 + 0.2 * i});
    add_part(scene, segment({-1, 0}, {1, 0}));
    const auto world = make_world(scene);
    run(*world, 2);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(world->balls()[static_cast<std::size_t>(i)].position.y, 0.1 + 0.2 * i, 1e-3);
    for (const Contact& contact : world->contacts()) EXPECT_GT(contact.separation, -1e-3);
}

/// Runs until all balls sleep. Returns the deepest overlap of the contacts then, in radii of 0.1 m.
double settle(World& world, double seconds) {
    for (int i = 0; i < 60 * seconds && world.statistics().asleep < world.balls().size(); ++i)
        world.step(1.0 / 60);
    EXPECT_EQ(world.statistics().asleep, world.balls().size());
    double deepest = 0;
    for (const Contact& contact : world.contacts()) deepest = std::max(deepest, -contact.separation / 0.1);
    return deepest;
}

TEST(KnownAnswers, ColumnOfTenFallsAsleepWhereItStands) {
    Scene scene = empty_scene({0, -9.8});
    scene.rest_speed = 0.1;
    for (int i = 0; i < 10; ++i) add_ball(scene, {0, 0.101 + 0.201 * i});
    add_part(scene, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
    scene.materials[0].restitution = std::sqrt(0.5);
    const auto world = make_world(scene);
    const double overlap = settle(*world, 5);
    EXPECT_LT(overlap, 5e-3);
    for (std::size_t i = 0; i < 10; ++i)
        EXPECT_NEAR(world->balls()[i].position.y, 0.1 + 0.2 * static_cast<double>(i), 1.1 * overlap);
}

TEST(KnownAnswers, HeapsComeToRestWithoutSinkingOrGainingEnergy) {
    const auto fall = [](Scene scene, int balls, double low) {
        scene.rest_speed = 0.1;
        scene.materials[0].restitution = std::sqrt(0.5);
        for (int i = 0; i < balls; ++i)
            add_ball(scene, {-1.38 + 0.21 * (i % 14) + 0.001 * (i % 7), low + 0.205 * (i / 14)});
        const auto world = make_world(scene);
        const double before = energy(*world, scene);
        EXPECT_LT(settle(*world, 20), 0.01);
        EXPECT_LT(energy(*world, scene), before);
        for (const Ball& ball : world->balls()) EXPECT_GT(ball.position.y, 0.09);
    };
    Scene pit = empty_scene({0, -9.8});
    add_part(pit, {shape::Polyline{{{-1.5, 90}, {-1.5, 1.5}, {0, 0}, {1.5, 1.5}, {1.5, 90}}, false}},
             {"", 0.7, 0, 0});
    fall(pit, 50, 1.8);
    Scene bin = empty_scene({0, -9.8});
    add_part(bin, {shape::Polyline{{{-1.5, 90}, {-1.5, 0}, {1.5, 0}, {1.5, 90}}, false}}, {"", 0.7, 0, 0});
    fall(bin, 200, 0.3);
}

TEST(KnownAnswers, OpposedFastBallsNeverPassThroughEachOther) {
    // Impact parameter 0.12, sum of radii 0.2.
    for (const double speed : {5.0, 50.0, 5e3}) {
        Scene scene = empty_scene();
        scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
        add_ball(scene, {-0.31 * speed, 0.06}, {speed, 0});
        add_ball(scene, {0.31 * speed, -0.06}, {-speed, 0});
        const auto world = make_world(scene);
        run(*world, 1);
        // The relative velocity along the line of centres (cosine 0.8) is reversed.
        const Ball& ball = world->balls()[0];
        EXPECT_NEAR(ball.velocity.x, speed - 2 * speed * 0.64, 1e-9 * speed) << speed;
        EXPECT_NEAR(ball.velocity.y, 2 * speed * 0.8 * 0.6, 1e-9 * speed) << speed;
        const double touched = (0.31 * speed - 0.08) / speed;
        EXPECT_NEAR(ball.position.x, -0.08 + (world->time() - touched) * ball.velocity.x, 1e-9 * speed);
    }
}

}  // namespace
}  // namespace flipside::custom::test
