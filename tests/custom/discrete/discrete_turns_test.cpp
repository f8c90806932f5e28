// Who flies free through a step, and what becomes of those that are met on the way.

#include <gtest/gtest.h>

#include "custom/broad_phase/registry.hpp"
#include "custom/flight.hpp"
#include "custom/scenes.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

constexpr double dt = 1.0 / 60;

TEST(DiscreteTurns, FreeBallFliesTheWholeStepInOneGo) {
    Scene scene = empty_scene({0.5, -9.81});
    scene.damping = 0.3;
    add_ball(scene, {0, 1}, {3, 2});
    add_part(scene, segment({-1, 0.5}, {1, 0.5}));  // in reach, but not on its way
    Ball ball = scene.balls[0];
    const auto world = make_world(scene);
    world->step(dt);
    fly_freely(ball, scene.gravity, Stretch(scene.damping, dt));
    EXPECT_EQ(world->balls()[0].position, ball.position);
    EXPECT_EQ(world->balls()[0].velocity, ball.velocity);
    EXPECT_EQ(world->statistics().narrow_tests, 0U);
}

TEST(DiscreteTurns, BallsThatMissEachOtherAreNotTested) {
    // Side by side within each other's reach, at 6 m/s.
    Scene scene = empty_scene();
    add_ball(scene, {0, 0}, {6, 0});
    add_ball(scene, {0.1, 0.21}, {-6, 0});
    const auto world = make_world(scene);
    world->step(dt);
    EXPECT_EQ(world->statistics().narrow_tests, 0U);
    EXPECT_EQ(world->statistics().impacts, 0U);
}

TEST(DiscreteTurns, ImpactLateInTheStepIsAnswered) {
    // The gap of 0.09 m closes in the last quarter of the step: e = 1 exchanges the velocities.
    for (const double drag : {0.0, 0.5}) {
        Scene scene = empty_scene();
        scene.damping = drag;
        add_ball(scene, {0, 0}, {6, 0});
        add_ball(scene, {0.29, 0}, {0, 0});
        const auto world = make_world(scene);
        world->step(dt);
        EXPECT_EQ(world->statistics().impacts, 1U);
        EXPECT_NEAR(world->balls()[0].velocity.x, 0, 1e-12);
        EXPECT_NEAR(world->balls()[1].velocity.x, 6 * std::exp(-drag * dt), 1e-3);
    }
}

TEST(DiscreteTurns, KickedBallMeetsThoseThatFlewFree) {
    // Kicked to 40 m/s, that is 0.17 m per flight, up a row of balls that nothing else could meet.
    Scene scene = empty_scene();
    add_ball(scene, {0, -0.85}, {0, -1});
    add_part(scene, segment({-9, -1}, {9, -1}), {"", 1, 0, 40});
    for (int i = 0; i < 5; ++i) add_ball(scene, {0, 0.5 * i}, {});
    const auto world = make_world(scene);
    double before = -1;
    for (int i = 0; i < 12; ++i) world->step(dt);
    for (const Ball& ball : world->balls()) {
        EXPECT_GT(ball.position.y, before + 0.2 - 1e-9);  // nobody passed anybody
        before = ball.position.y;
    }
    EXPECT_NEAR(world->balls()[5].velocity.y, 40, 1e-9);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(world->balls()[static_cast<std::size_t>(i)].velocity.y, 0, 1e-9);
}

TEST(DiscreteTurns, WhoIsMetIsMetByThoseWhoWereMet) {
    // A row on a slant: each lies in the box of the one before, and its way touches nobody's. Within one
    // flight the hit goes all the way through it.
    Scene scene = empty_scene();
    const Vec2 along = unit(Vec2{1, 1});
    add_ball(scene, -0.21 * along, 2 * along);
    for (int i = 0; i < 3; ++i) add_ball(scene, {0.18 * i, 0.18 * i}, {});
    const auto world = make_world(scene, {{"motion_iterations", "1"}});
    world->step(0.1);
    EXPECT_EQ(world->statistics().impacts, 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(length(world->balls()[i].velocity), 0, 1e-12);
    const double gaps = 0.01 + 2 * (0.18 * std::sqrt(2.0) - 0.2);
    EXPECT_NEAR(length(world->balls()[3].position - (Vec2{0.36, 0.36} + (0.2 - gaps) * along)), 0, 1e-12);
}

TEST(DiscreteTurns, SleepersWokenByAHitTouchAsTheyDid) {
    // Three asleep side by side on a floor. The first is hit from the side; what it touches, asleep or still,
    // it touches on.
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0;
    add_part(scene, segment({-1, 0}, {2, 0}), {"", 0, 0, 0});
    for (int i = 0; i < 3; ++i) add_ball(scene, {0.2 * i, 0.1}).asleep = true;
    add_ball(scene, {-0.21, 0.1}, {0.5, 0});
    const auto world = make_world(scene);
    const auto touch = [&](BallNumber ball, Other other) {
        return std::ranges::any_of(world->contacts(),
                                   [&](const Contact& c) { return c.ball == ball && c.other == other; });
    };
    int step = 0;
    while (world->balls()[0].asleep) {
        world->step(dt);
        for (BallNumber i = 0; i < 4; ++i) EXPECT_TRUE(touch(i, Other::part(0))) << i << " at " << step;
        EXPECT_TRUE(touch(0, Other::ball(1))) << step;
        EXPECT_TRUE(touch(1, Other::ball(2))) << step;
        ASSERT_LT(++step, 4);
    }
}

TEST(DiscreteTurns, SleepersStruckByAPartStrikeOthers) {
    // A segment turns into a ball that sleeps since the scene began, which flies on into another: all within
    // one step, before the segment is there again.
    constexpr double rate = 9;
    Scene scene = empty_scene({});
    const Vec2 pivot{5, 0};
    add_part(scene, segment(pivot, pivot + Vec2{1, 0})).motion = motion::Turn{pivot, rate, true};
    add_ball(scene, pivot + Vec2{0.8, 0.15}).asleep = true;
    add_ball(scene, pivot + Vec2{0.8, 0.36}).asleep = true;
    // e = 1: the ball leaves with twice the speed of the segment, which touches it at this distance.
    const double away = std::sqrt(0.8 * 0.8 + 0.15 * 0.15 - 0.1 * 0.1);
    const double angle = std::atan2(0.15, 0.8) - std::atan2(0.1, away), speed = 2 * rate * away;
    for (const int iterations : {8, 64}) {
        const auto world = make_world(scene, {{"motion_iterations", std::to_string(iterations)}});
        world->step(0.008);
        const Ball &struck = world->balls()[0], &other = world->balls()[1];
        EXPECT_FALSE(struck.asleep);
        EXPECT_FALSE(other.asleep);
        EXPECT_EQ(world->statistics().impacts, 2U);
        const Vec2 both = struck.velocity + other.velocity;
        // The segment answers as it stands when the flight ends.
        const double turned = rate * 0.008 / iterations;
        EXPECT_NEAR(length(both - speed * perp(from_angle(angle))), 0, speed * turned);
    }
}

// Balls of several sizes are kicked about between walls, a bumper and a turning segment.
RC_GTEST_PROP(DiscreteTurns, HowPairsAreSoughtChangesNoBit, ()) {
    const auto within = [](double from, double to) {
        return from + (to - from) * *rc::gen::inRange(0, 1001) / 1000;
    };
    Scene scene = empty_scene({0, *rc::gen::arbitrary<bool>() ? -9.81 : 0});
    scene.damping = *rc::gen::arbitrary<bool>() ? 0.4 : 0;
    for (int i = *rc::gen::inRange(5, 60); i > 0; --i)
        add_ball(scene, {within(0, 3), within(0.2, 3)}, {within(-6, 6), within(-6, 6)}, within(0.05, 0.12));
    add_part(scene, {shape::Polyline{{{-0.3, -0.3}, {3.3, -0.3}, {3.3, 3.3}, {-0.3, 3.3}}, true}},
             {"", 0.8, 0.1, 0});
    add_part(scene, {shape::Circle{{1.5, 0.3}, 0.2}}, {"", 0.8, 0, 30});
    add_part(scene, segment({2, 0.5}, {3, 0.5})).motion = motion::Turn{{2.5, 0.5}, 9, true};
    const auto balls_with = [&](std::string_view steps, std::string_view broad_phase, bool restored) {
        auto world = make_world(scene, {{"search_steps", steps}, {"broad_phase", broad_phase}});
        run(*world, 0.25);
        if (restored) {
            const State state = world->save();
            world = make_world(scene);
            world->restore(state);
        }
        run(*world, 0.25);
        return world->save().balls;
    };
    const auto expected = balls_with("1", "brute", false);
    for (const BroadPhaseKind& kind : broad_phases) RC_ASSERT(balls_with("2", kind.name, false) == expected);
    RC_ASSERT(balls_with("20", "grid", false) == expected);
    RC_ASSERT(balls_with("2", "grid", true) == expected);
}

}  // namespace
}  // namespace flipside::custom::test
