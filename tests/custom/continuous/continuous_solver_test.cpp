// The continuous solver on whole scenes: independence of dt, continuation from a saved state, friction in
// resting contacts. Single cases with known answers are tested in lab/cases.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "places.hpp"
#include "world/scene_file.hpp"

namespace flipside::custom::test {
namespace {

constexpr double g = 9.81;

Scene pinball() {
    return load_scene(flipside::test::source("assets/scenes/pinball.json"));
}

std::unique_ptr<World> continuous(const Scene& scene) {
    return make_world(scene, {{"solver", "continuous"}});
}

void add_launched(World& world, const Scene& scene, Vec2 position, Vec2 velocity) {
    Ball ball = scene.launcher->ball;
    ball.position = position;
    ball.velocity = velocity;
    world.add(ball);
}

// Before chaos sets in, trajectories of different steps agree to 1e-9 radii.
TEST(ContinuousSolver, StepSizeDoesNotMatter) {
    const Scene scene = pinball();
    const std::pair<Vec2, Vec2> starts[] = {
        {{0.162, 0.86}, {0.1, -0.5}}, {{0.25, 0.7}, {1, 0.3}}, {{0.055, 0.33}, {0, -0.2}}};
    for (const auto& [position, velocity] : starts) {
        std::vector<Vec2> ends;
        std::uint64_t impacts = 0;
        for (const int rate : {30, 60, 1000}) {
            const auto world = continuous(scene);
            add_launched(*world, scene, position, velocity);
            world->apply(control::Flip{Side::left, true});
            impacts = 0;
            for (int i = 0; i < rate * 6 / 10; ++i) {
                world->step(1.0 / rate);
                impacts += world->statistics().impacts;
            }
            ends.push_back(world->balls()[0].position);
        }
        const double r = scene.launcher->ball.radius;
        std::printf("%llu impacts: 1/30 differs by %.1e r, 1/1000 by %.1e r\n",
                    static_cast<unsigned long long>(impacts), length(ends[0] - ends[1]) / r,
                    length(ends[2] - ends[1]) / r);
        EXPECT_LE(length(ends[0] - ends[1]), 1e-9 * r);
        EXPECT_LE(length(ends[2] - ends[1]), 1e-9 * r);
    }
}

// A world restored in the middle of a run continues with the same bits.
TEST(ContinuousSolver, ContinuesFromASavedState) {
    const Scene scene = pinball();
    const auto external = [](World& world, int step) {
        if (step % 40 == 0) world.apply(control::Flip{Side::left, true});
        if (step % 40 == 12) world.apply(control::Flip{Side::left, false});
        world.step(1.0 / 60);
    };
    for (const int balls : {1, 4}) {
        auto through = continuous(scene);
        for (int i = 0; i < balls; ++i)
            add_launched(*through, scene, {0.12 + 0.06 * i, 0.85}, {0.2 * (i % 3) - 0.2, 0});
        for (int step = 0; step < 600; ++step) {
            if (step % 20 != 0) {
                external(*through, step);
                continue;
            }
            const auto restored = continuous(scene);
            restored->restore(through->save());
            external(*through, step);
            external(*restored, step);
            ASSERT_TRUE(std::ranges::equal(through->balls(), restored->balls())) << "step " << step;
        }
    }
}

// A disc on an incline rolls with ⅔·g·sin α when tan α ≤ 3µ, and slides with g·(sin α − µ·cos α) above.
TEST(ContinuousSolver, RollsOrSlidesDownAnIncline) {
    for (const double alpha : {0.2, 0.7}) {
        for (const double dt : {1.0 / 30, 1.0 / 1000}) {
            const double friction = 0.15;
            Scene scene = empty_scene(g * Vec2{std::sin(alpha), -std::cos(alpha)});
            scene.materials[0].friction = 1;
            add_part(scene, segment({-1, 0}, {90, 0}), {"", 0, friction * friction, 0});
            add_ball(scene, {0, 0.1});
            const auto world = continuous(scene);
            run(*world, 1, dt);
            const bool rolls = std::tan(alpha) <= 3 * friction;
            const double a =
                rolls ? 2.0 / 3 * g * std::sin(alpha) : g * (std::sin(alpha) - friction * std::cos(alpha));
            EXPECT_NEAR(world->balls()[0].position.x, a / 2, 1e-12 * a / dt);
            EXPECT_NEAR(world->balls()[0].velocity.x, a, 1e-12 * a / dt);
            const double spin = rolls ? -a / 0.1 : -2 * friction * g * std::cos(alpha) / 0.1;
            EXPECT_NEAR(world->balls()[0].spin, spin, 1e-11 * std::abs(spin) / dt);
        }
    }
}

// A ball that starts without spin on a rough floor rolls at 2v₀/3 after v₀/(3µg).
TEST(ContinuousSolver, SlidingTurnsIntoRolling) {
    const double friction = 0.2, v = 3, switches = v / (3 * friction * g);
    Scene scene = empty_scene({0, -g});
    scene.materials[0].friction = 1;
    add_part(scene, segment({-1, 0}, {90, 0}), {"", 0, friction * friction, 0});
    add_ball(scene, {0, 0.1}, {v, 0});
    const auto world = continuous(scene);
    run(*world, 2);
    const Ball& ball = world->balls()[0];
    const double x = v * switches - friction * g * switches * switches / 2 + 2 * v / 3 * (2 - switches);
    EXPECT_NEAR(ball.velocity.x, 2 * v / 3, 1e-12);
    EXPECT_NEAR(ball.spin, -2 * v / 3 / 0.1, 1e-10);
    EXPECT_NEAR(ball.position.x, x, 1e-11);
}

// A flipper lifts the ball that lies on it; the ball never passes through it, and leaves it or rests at the
// stop.
TEST(ContinuousSolver, RidesAMovingPart) {
    Scene scene = empty_scene({0, -g});
    Part& part = add_part(scene, {shape::Flipper{{0, 0}, 1, 0.1, 0.1, 0}}, {"", 0, 0, 0});
    part.motion = motion::Flip{Side::left, 0.3, 0.5, 0.5};
    add_ball(scene, {0.5, 0.2});
    std::vector<Vec2> ends;
    for (const double dt : {1.0 / 30, 1.0 / 240}) {
        const auto world = continuous(scene);
        world->apply(control::Flip{Side::left, true});
        for (int i = 0; i < std::lround(0.3 / dt); ++i) {
            world->step(dt);
            const Vec2 p = rotated(world->balls()[0].position, -world->parts()[0].angle);
            EXPECT_NEAR(p.y, 0.2, 1e-12);
        }
        ends.push_back(world->balls()[0].position);
    }
    EXPECT_LE(length(ends[0] - ends[1]), 1e-11);
    EXPECT_LT(ends[0].x, 0.5);  // it slides down the raised side
}

// A ball slides along the inside of an arc and onto the line that continues it, without separating. Its speed
// follows from its energy, for any step.
TEST(ContinuousSolver, SlidesOverASmoothJoint) {
    const double pi = std::numbers::pi, slope = 28 * pi / 180, radius = 0.034, r = 0.0135;
    const Vec2 center{0.45, 0.15}, down = {-std::cos(slope), -std::sin(slope)};
    const Vec2 joint = center - radius * perp(-down), far = joint + 0.2 * down;
    Scene scene = empty_scene({0, -1.11});
    const shape::Arc arc{center, radius, 1.5 * pi + slope, 2 * pi};
    add_part(scene, {shape::Compound{{{arc}, segment(far, joint)}}}, {"", 0.5, 0, 0});
    const Vec2 out = from_angle(-0.1);
    add_ball(scene, center + (radius - r) * out, 0.5 * -perp(out), r);
    const double start = scene.balls[0].position.y;
    for (const int rate : {30, 60, 1000, 7680}) {
        const auto world = continuous(scene);
        std::uint64_t impacts = 0;
        while (world->balls()[0].position.x > far.x + 0.05) {
            world->step(1.0 / rate);
            const Ball& ball = world->balls()[0];
            impacts += world->statistics().impacts;
            ASSERT_EQ(world->statistics().handed_over, 0U);
            EXPECT_NEAR(length_squared(ball.velocity), 0.25 + 2 * 1.11 * (start - ball.position.y), 1e-12);
            if (dot(ball.position - joint, down) < 0) continue;
            EXPECT_NEAR(dot(ball.position - joint, perp(-down)), r, 1e-15);
        }
        EXPECT_EQ(impacts, 0U) << rate;
    }
}

// A ball that slides off the end of a face leaves it along its tangent, without an impact at the corner.
TEST(ContinuousSolver, SlidesOffAnEndWithoutAHit) {
    const double v = 1.7, r = 0.0135, edge = 0.3, weight = 1.11;
    const Shape shapes[] = {
        segment({0.1, 0.2}, {edge, 0.2}),
        {shape::Polygon{{{0.1, 0.15}, {edge, 0.15}, {edge, 0.2}, {0.1, 0.2}}}},
        {shape::Capsule{{0.1, 0.19}, {edge, 0.19}, 0.01}},
    };
    for (const Shape& shape : shapes)
        for (const int rate : {30, 60, 1000}) {
            Scene scene = empty_scene({0, -weight});
            add_part(scene, shape, {"", 0.5, 0, 0});
            add_ball(scene, {0.15, 0.2 + r}, {v, 0}, r);
            const auto world = continuous(scene);
            run(*world, 0.3, 1.0 / rate);
            const Ball& ball = world->balls()[0];
            const double falls = world->time() - (edge - 0.15) / v;
            EXPECT_NEAR(ball.position.x, 0.15 + v * world->time(), 1e-13);
            EXPECT_NEAR(ball.position.y, 0.2 + r - weight * falls * falls / 2, 1e-13);
        }
}

// A ball that bounces on a pin slides off it when its bounces are lower than rounding.
TEST(ContinuousSolver, BouncesOnACurveEnd) {
    for (const double e : {0.4, 0.9}) {
        for (const double x : {0.0005, 0.001, 0.0015}) {
            Scene scene = empty_scene({0, -g});
            scene.rest_speed = 0;
            add_part(scene, {shape::Circle{{0, 0}, 0.01}}, {"", e, 0, 0});
            add_ball(scene, {x, 0.035}, {}, 0.02);
            const auto world = continuous(scene);
            std::uint64_t impacts = 0;
            for (int i = 0; i < 90; ++i) {
                world->step(1.0 / 60);
                impacts += world->statistics().impacts;
                ASSERT_EQ(world->statistics().handed_over, 0U);
            }
            EXPECT_LT(impacts, 400U);
            EXPECT_LT(world->balls()[0].position.y, -0.05);
        }
    }
}

// Within one step, a ball hits a wall 0.9 m away at 10 m/s and then a ball 1.2 m away in the other direction.
TEST(ContinuousSolver, ABallThatBouncesBackHitsTheBallBehindIt) {
    Scene scene = empty_scene();
    add_ball(scene, {0, 0}, {10, 0});
    add_ball(scene, {-0.5, 0}, {});
    add_part(scene, segment({1, -1}, {1, 1}));
    const auto world = continuous(scene);
    world->step(0.3);
    EXPECT_EQ(world->statistics().impacts, 2U);
    EXPECT_NEAR(world->balls()[0].position.x, -0.3, 1e-12);
    EXPECT_NEAR(world->balls()[1].position.x, -0.5 - 0.9, 1e-12);
    EXPECT_NEAR(world->balls()[1].velocity.x, -10, 1e-12);
}

// A ball that passes over another too fast to rest on it flies, and one that bounces on it bounces. Neither
// forms an island.
TEST(ContinuousSolver, SeparatingBallsFormNoIsland) {
    const auto first_step = [](Vec2 velocity) {
        Scene scene = empty_scene({0, -g});
        scene.rest_speed = 0.1;
        add_part(scene, segment({-1, 0}, {1, 0}), {"", 0, 0, 0});
        add_ball(scene, {0, 0.1});
        add_ball(scene, {0, 0.3}, velocity);
        auto world = continuous(scene);
        world->step(1.0 / 120);
        EXPECT_EQ(world->statistics().handed_over, 0U);
        const double t = world->time();
        const Vec2 expected = Vec2{0, 0.3} + t * velocity + t * t / 2 * Vec2{0, -g};
        EXPECT_LE(length(world->balls()[1].position - expected), 1e-15);
    };
    first_step({1.5, 0});
    first_step({0, 0.09});
}

// However long the steps are: also in those without a tick.
TEST(ContinuousSolver, MembersAreCountedInEveryStep) {
    Scene column = empty_scene({0, -9.81});
    add_part(column, segment({-1, 0}, {1, 0}), {"", 0, 0, 0});
    column.materials[0].restitution = 0;
    for (int i = 0; i < 3; ++i) add_ball(column, {0, 0.1 + 0.2 * i});
    for (const int steps_per_second : {60, 240, 960, 2000}) {
        const auto world = make_world(column, {{"solver", "continuous"}, {"sleep", "off"}});
        run(*world, 0.3, 1.0 / steps_per_second);
        for (int step = 0; step < steps_per_second / 10; ++step) {
            world->step(1.0 / steps_per_second);
            EXPECT_EQ(world->statistics().handed_over, 3U) << steps_per_second;
        }
    }
}

// Balls in resting contact form islands, and statistics count them; none sinks in or is lost.
TEST(ContinuousSolver, HeapsAreIslands) {
    const auto settles = [](const Scene& scene, double deepest_allowed) {
        const auto world = make_world(scene, {{"solver", "continuous"}, {"sleep", "off"}});
        run(*world, 6);
        double deepest = 0;
        for (const Contact& contact : world->contacts())
            deepest = std::max(deepest, -contact.separation / 0.1);
        EXPECT_LE(deepest, deepest_allowed);
        EXPECT_EQ(world->balls().size(), scene.balls.size());
        EXPECT_EQ(world->statistics().handed_over, scene.balls.size());
        for (const Ball& ball : world->balls()) EXPECT_LT(length(ball.velocity), 0.5);
    };
    Scene column = empty_scene({0, -9.81});
    add_part(column, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
    column.materials[0].restitution = 0.5;
    for (int i = 0; i < 10; ++i) add_ball(column, {0, 0.1 + 0.21 * i});
    settles(column, 0.02);

    Scene pit = empty_scene({0, -9.81});
    pit.materials[0].restitution = 0.5;
    add_part(pit, {shape::Polyline{{{-4, 4}, {0, 0}, {4, 4}}, false}}, {"", 0.5, 0, 0});
    for (int i = 0; i < 20; ++i)
        add_ball(pit, {-0.9 + 0.21 * (i % 9) + 0.003 * (i / 9), 1.2 + 0.25 * (i / 9)});
    settles(pit, 0.03);
}

TEST(ContinuousSolver, DeepOverlapsAreCorrectedInFlight) {
    Scene scene = empty_scene({0, -g});
    add_ball(scene, {-0.09, 0});
    add_ball(scene, {0.09, 0});
    const auto world = continuous(scene);
    double overlap = 0.2;
    for (int i = 0; i < 30; ++i) {
        world->step(1.0 / 60);
        const Vec2 between = world->balls()[1].position - world->balls()[0].position;
        overlap = 2 - length(between) / 0.1;
        EXPECT_EQ(between.y, 0);
    }
    EXPECT_LT(overlap, 1.1e-3);
    // The position correction separates them without changing their fall.
    for (const Ball& ball : world->balls()) {
        EXPECT_EQ(ball.velocity.x, 0);
        EXPECT_NEAR(ball.velocity.y, -g / 2, 1e-12);
        EXPECT_NEAR(ball.position.y, -g / 8, 1e-12);
    }
}

TEST(ContinuousSolver, BallsAtOnePointComeApart) {
    for (const int balls : {2, 12})
        for (const Vec2 gravity : {Vec2{0, -g}, Vec2{}}) {
            Scene scene = empty_scene(gravity);
            add_part(scene, segment({-9, -3}, {9, -3}));
            for (int i = 0; i < balls; ++i) add_ball(scene, {0, 0});
            const auto world = continuous(scene);
            run(*world, 3);
            EXPECT_EQ(std::ssize(world->balls()), balls);
            for (const Contact& contact : world->contacts())
                EXPECT_GT(contact.separation, -0.02 * 0.1) << balls << " balls, gravity " << gravity.y;
        }
}

// No outline is near a ball in the middle of a large solid.
TEST(ContinuousSolver, ABallThatBeginsDeepInsideASolidIsOutAfterAStep) {
    const Vec2 inside{0.2, 0.3};
    const struct {
        const char* name = "";
        Shape solid;
        Vec2 out;  // the nearest place
    } solids[] = {{"polygon", {shape::Polygon{{{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}}}, {0.2, 1.1}},
                  {"circle", {shape::Circle{{0, 0}, 1}}, 1.1 / length(inside) * inside},
                  {"capsule", {shape::Capsule{{-2, 0}, {2, 0}, 1}}, {0.2, 1.1}}};
    for (const auto& [name, solid, out] : solids)
        for (const bool turns : {false, true}) {
            Scene scene = empty_scene({0, -g});
            Part& part = add_part(scene, solid);
            if (turns) part.motion = motion::Turn{{0, 0}, 0.1, true};
            add_ball(scene, inside);
            const auto world = continuous(scene);
            world->step(1.0 / 240);
            EXPECT_LT(length(world->balls()[0].position - out), 1e-3) << name << ", turns: " << turns;
            for (const Contact& contact : world->contacts())
                EXPECT_GE(contact.separation, -1e-9) << name << ", turns: " << turns;
        }
}

TEST(ContinuousSolver, EndlessImpactsAreLimited) {
    // The heavy ball, at a million radii per second, drives the light one against the wall. The light one
    // bounces between both: without a limit that step has a million impacts.
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    const double e = std::sqrt(0.5);
    scene.materials[0].restitution = e;
    add_part(scene, {shape::Polyline{{{-1, 0}, {1, 0}, {1, 3}, {-1, 3}}, true}}, {"", e, 0, 0});
    add_ball(scene, {0, 0.1}, {}, 0.1, 1);
    add_ball(scene, {0.01, 1.5}, {0, -1e5}, 0.1, 10);
    const auto world = continuous(scene);
    std::uint64_t most = 0;
    for (int i = 0; i < 60; ++i) {
        world->step(1.0 / 30);
        most = std::max(most, world->statistics().narrow_tests);
        for (const Ball& ball : world->balls()) {
            EXPECT_LT(std::abs(ball.position.x), 1);
            EXPECT_LT(std::abs(ball.position.y - 1.5), 1.5);
        }
    }
    EXPECT_LT(most, 100'000U);
}

TEST(ContinuousSolver, ABallThatIsFrozenAtTheEndOfAWindowKeepsItsVelocity) {
    Scene scene = empty_scene();
    add_part(scene, segment({1, -5}, {1, 5}));
    add_ball(scene, {0.625, 2}, {1, 0}, 0.25);  // meets the wall after an eighth of a second
    add_ball(scene, {0.5, -2}, {1, 0}, 0.25);   // at the end of the window, after a quarter
    const auto world = make_world(scene, {{"max_impacts", "1"}});
    world->step(0.25);
    EXPECT_EQ(world->balls()[0].velocity, (Vec2{-1, 0}));
    EXPECT_EQ(world->balls()[1].velocity, (Vec2{1, 0}));
    world->step(0.25);
    EXPECT_EQ(world->balls()[1].velocity, (Vec2{-1, 0}));
}

}  // namespace
}  // namespace flipside::custom::test
