// The simple solver against known answers and its documented errors.

#include "custom/simple/simple_solver.hpp"

#include <gtest/gtest.h>

#include "custom/broad_phase/registry.hpp"
#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

std::unique_ptr<World> simple_world(const Scene& scene, std::string_view motion_iterations = "4",
                                    std::string_view broad_phase = "quadtree") {
    return make_world(
        scene,
        {{"solver", "simple"}, {"motion_iterations", motion_iterations}, {"broad_phase", broad_phase}});
}

/// A square box of elastic walls with balls of several sizes, a turning bar and a sensor.
Scene gas() {
    Scene scene = empty_scene();
    for (int i = 0; i < 40; ++i)
        add_ball(scene, {0.3 * (i % 7), 0.3 * (i / 7)}, {std::sin(3.0 * i), std::cos(5.0 * i)},
                 0.05 + 0.01 * (i % 6), 1 + i % 4);
    add_part(scene, {shape::Polyline{{{-0.5, -0.5}, {2.5, -0.5}, {2.5, 2.5}, {-0.5, 2.5}}, true}});
    add_part(scene, segment({1, 2.2}, {2, 2.2})).motion = motion::Turn{{1.5, 2.2}, 2, true};
    add_part(scene, segment({0, 1}, {2, 1})).sensor = true;
    return scene;
}

double energy(const World& world, const Scene& scene) {
    double sum = 0;
    for (const Ball& ball : world.balls())
        sum += ball.mass * (0.5 * length_squared(ball.velocity) - dot(scene.gravity, ball.position));
    return sum;
}

Vec2 momentum(const World& world) {
    Vec2 sum;
    for (const Ball& ball : world.balls()) sum += ball.mass * ball.velocity;
    return sum;
}

TEST(SimpleSolver, EveryBroadPhaseGivesTheSameBits) {
    const Scene scene = gas();
    const auto expected = simple_world(scene, "4", "brute");
    run(*expected, 4);
    for (const BroadPhaseKind& kind : std::span(broad_phases).subspan(1)) {
        const auto world = simple_world(scene, "4", kind.name);
        run(*world, 4);
        ASSERT_EQ(world->balls().size(), expected->balls().size());
        for (std::size_t i = 0; i < world->balls().size(); ++i) {
            EXPECT_EQ(world->balls()[i].position, expected->balls()[i].position) << kind.name;
            EXPECT_EQ(world->balls()[i].velocity, expected->balls()[i].velocity) << kind.name;
        }
        EXPECT_NE(world->statistics().pair_tests, expected->statistics().pair_tests) << kind.name;
    }
}

TEST(SimpleSolver, ElasticDropKeepsItsEnergy) {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 1.1});
    add_part(scene, segment({-1, 0}, {1, 0}));
    const auto world = simple_world(scene);
    const double before = energy(*world, scene);
    run(*world, 90);
    EXPECT_NEAR(energy(*world, scene), before, 1e-10 * before);
}

TEST(SimpleSolver, PairKeepsMomentumAndBouncesAsTold) {
    for (const double restitution : {0.0, 0.5, 1.0}) {
        Scene scene = empty_scene();
        scene.materials[0].restitution = std::sqrt(restitution);  // of both: the product counts
        add_ball(scene, {-0.5, 0}, {2, 0}, 0.1, 3);
        add_ball(scene, {0.5, 0}, {-1, 0}, 0.1, 1);
        const auto world = simple_world(scene);
        run(*world, 1);
        const auto balls = world->balls();
        EXPECT_NEAR(balls[1].velocity.x - balls[0].velocity.x, 3 * restitution, 1e-12) << restitution;
        EXPECT_NEAR(momentum(*world).x, 5, 1e-12) << restitution;
    }
}

/// Error of the position of a ball 1 s after it was thrown at a wall.
double late_by(std::string_view motion_iterations) {
    Scene scene = empty_scene();
    // The impact is at 0.617 s, between the ends of two iterations.
    add_ball(scene, {-0.717, 0}, {1, 0.5});
    add_part(scene, segment({0, -5}, {0, 5}));
    const auto world = simple_world(scene, motion_iterations);
    run(*world, 1, 0.1);
    return length(world->balls()[0].position - Vec2{-0.1 - 0.383, 0.5});
}

TEST(SimpleSolver, ImpactIsUpToOneMotionIterationLate) {
    // The ball overlaps until the end of the iteration and is then pushed out: it loses that distance.
    for (const auto* iterations : {"1", "3", "10", "30"}) {
        const double duration = 0.1 / std::stod(iterations);
        EXPECT_GT(late_by(iterations), 0) << iterations;
        EXPECT_LE(late_by(iterations), 1.0 * duration) << iterations;
    }
    EXPECT_LT(late_by("30"), late_by("1") / 5);
}

TEST(SimpleSolver, FastBallTunnelsWhereItMovesFartherThanItsDiameter) {
    Scene scene = empty_scene();
    add_ball(scene, {-0.75, 0}, {30, 0});  // 0.5 m a step: from 0.25 m before the wall to 0.25 m behind it
    add_part(scene, segment({0, -5}, {0, 5}));
    const auto coarse = simple_world(scene, "1");
    const auto fine = simple_world(scene, "16");
    run(*coarse, 0.1);
    run(*fine, 0.1);
    EXPECT_GT(coarse->balls()[0].position.x, 1);
    EXPECT_LT(fine->balls()[0].position.x, -0.1);
}

/// The deepest overlap of a column of ten balls in a tube after 2 s, in radii.
double overlap_in_column(std::string_view collision_iterations) {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0;
    for (int i = 0; i < 10; ++i) add_ball(scene, {0, 0.1 + 0.2 * i});
    add_part(scene, segment({-1, 0}, {1, 0}));
    const auto world =
        make_world(scene, {{"solver", "simple"}, {"collision_iterations", collision_iterations}});
    run(*world, 2);
    return deepest_overlap(world->contacts()) / 0.1;
}

TEST(SimpleSolver, CollisionIterationsTakeOverlapOutOfHeaps) {
    const double few = overlap_in_column("1"), many = overlap_in_column("32");
    EXPECT_GT(few, 0);
    EXPECT_LT(many, few / 2);
}

TEST(SimpleSolver, GateLetsThroughFromBehindOnly) {
    for (const double side : {-1.0, 1.0}) {
        Scene scene = empty_scene();
        add_ball(scene, {0, 0.5 * side}, {0, -side});
        add_part(scene, {shape::Gate{{-0.3, 0}, {0.3, 0}, {0, 1}}});
        const auto world = simple_world(scene);
        run(*world, 1);
        // The normal points up: from below it passes, from above it bounces.
        EXPECT_NEAR(world->balls()[0].velocity.y, 1, 1e-12) << side;
        EXPECT_NEAR(world->balls()[0].position.y, 0.5 + (side > 0 ? 0.2 : 0), 0.02) << side;
        EXPECT_FALSE(world->parts()[0].open) << side;
    }
}

TEST(SimpleSolver, GateLetsThroughWhatBeginsDeepInIt) {
    for (const double share : {-0.9, -0.4, 0.0, 0.4, 0.9}) {
        Scene scene = empty_scene();
        Ball& ball = add_ball(scene, {0, 0}, {0, -1});
        ball.position.y = share * ball.radius;
        add_part(scene, {shape::Gate{{-0.3, 0}, {0.3, 0}, {0, 1}}});
        const auto world = simple_world(scene);
        run(*world, 0.5);
        EXPECT_EQ(world->balls()[0].velocity.y < 0, share < 0.5) << share;
        EXPECT_FALSE(world->parts()[0].open) << share;
    }
}

TEST(SimpleSolver, SensorTellsWhoEntersAndLeaves) {
    Scene scene = empty_scene();
    add_ball(scene, {-1, 0}, {1, 0});
    add_part(scene, {shape::Circle{{0, 0}, 0.3}}).sensor = true;
    const auto world = simple_world(scene);
    std::vector<std::pair<EventKind, double>> seen;
    for (int i = 0; i < 120; ++i) {
        world->step(1.0 / 60);
        for (const Event& event : world->events()) seen.emplace_back(event.kind, event.time);
    }
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[0].first, EventKind::sensor_begin);
    EXPECT_NEAR(seen[0].second, 0.6, 1.001 / 60);  // at the end of a step
    EXPECT_EQ(seen[1].first, EventKind::sensor_end);
    EXPECT_NEAR(seen[1].second, 1.4, 1.001 / 60);
}

TEST(SimpleSolver, TargetFallsWhenItIsHit) {
    Scene scene = empty_scene();
    add_ball(scene, {-1, 0}, {1, 0});
    add_part(scene, segment({0, -1}, {0, 1})).target = true;
    const auto world = simple_world(scene);
    run(*world, 2);
    EXPECT_TRUE(world->parts()[0].down);
    EXPECT_NEAR(world->balls()[0].velocity.x, -1, 1e-12);
}

TEST(SimpleSolver, TurningPartThrowsABall) {
    // A bar that turns at 2 rad/s about the origin hits a resting ball 1 m from the pivot at 2 m/s.
    Scene scene = empty_scene();
    add_ball(scene, {1, 0.5}, {}, 0.01);
    add_part(scene, segment({0, 0}, {2, 0})).motion = motion::Turn{{0, 0}, 2, true};
    const auto world = simple_world(scene, "64");
    run(*world, 0.5);
    // Elastic, off a heavy surface: twice the speed of the surface at the point of contact, √1.25 m from the
    // pivot.
    EXPECT_NEAR(length(world->balls()[0].velocity), 2 * 2 * std::sqrt(1.25), 0.05);
}

TEST(SimpleSolver, NobodyFallsAsleep) {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0;
    add_ball(scene, {0, 0.1});
    add_part(scene, segment({-1, 0}, {1, 0}));
    const auto world = simple_world(scene);
    run(*world, 5);
    EXPECT_FALSE(world->balls()[0].asleep);
    EXPECT_EQ(world->statistics().asleep, 0U);
    EXPECT_EQ(world->statistics().solver, "simple");
}

}  // namespace
}  // namespace flipside::custom::test
