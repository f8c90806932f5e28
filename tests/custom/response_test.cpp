#include "custom/response.hpp"

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

Ball ball_with(Vec2 velocity, double spin = 0, double mass = 2, double radius = 0.5) {
    Ball ball;
    ball.velocity = velocity;
    ball.spin = spin;
    ball.mass = mass;
    ball.radius = radius;
    return ball;
}

const Touch floor_touch{{0, 0}, {0, 1}, 0, false};
const Surroundings weightless{{0, 0}, 0.01};

TEST(Response, ReflectsTheNormalSpeedTimesRestitution) {
    Ball ball = ball_with({3, -2});
    const Impact hit = respond(ball, floor_touch, {}, {0.5, 0, 0}, weightless);
    EXPECT_TRUE(hit.happened);
    EXPECT_EQ(hit.speed, 2);
    EXPECT_EQ(hit.impulse, 6);  // (1 + e)·m·v
    EXPECT_EQ(ball.velocity, (Vec2{3, 1}));
    EXPECT_EQ(ball.spin, 0);
}

TEST(Response, LeavesWhatMovesAway) {
    Ball ball = ball_with({3, 2});
    EXPECT_FALSE(respond(ball, floor_touch, {}, {0.5, 0, 9}, weightless).happened);
    EXPECT_EQ(ball.velocity, (Vec2{3, 2}));
}

TEST(Response, KickIsTheLeastOutgoingSpeed) {
    Ball slow = ball_with({0, -1}), fast = ball_with({0, -10}), resting = ball_with({0, -0.005});
    EXPECT_TRUE(respond(slow, floor_touch, {}, {0.5, 0, 3}, weightless).happened);
    EXPECT_EQ(slow.velocity.y, 3);
    EXPECT_TRUE(respond(fast, floor_touch, {}, {0.5, 0, 3}, weightless).happened);
    EXPECT_EQ(fast.velocity.y, 5);
    EXPECT_FALSE(respond(resting, floor_touch, {}, {0.5, 0, 3}, weightless).happened);
    EXPECT_EQ(resting.velocity.y, 0);
}

TEST(Response, MovingSurface) {
    // v' = −e·v + (1+e)·u along the normal.
    for (const double u : {4.0, -1.0}) {
        Ball ball = ball_with({0, -2});
        EXPECT_TRUE(respond(ball, floor_touch, {0, u}, {0.5, 0, 0}, weightless).happened);
        EXPECT_NEAR(ball.velocity.y, 0.5 * 2 + 1.5 * u, 1e-15);
    }
}

TEST(Response, FrictionIsCoulombCappedAtSticking) {
    for (const double mu : {0.05, 0.2, 0.9})
        for (const double spin : {0.0, 3.0, -20.0}) {
            Ball ball = ball_with({3, -2}, spin);
            const double slip = 3 + ball.radius * spin;  // of the rim at the point of contact: v + r·ω
            ASSERT_TRUE(respond(ball, floor_touch, {}, {0.5, mu, 0}, weightless).happened);
            const double normal = 1.5 * 2 * 2;
            const double limit = std::min(mu * normal, ball.mass * std::abs(slip) / 3);
            const double support = slip > 0 ? -limit : limit;
            EXPECT_NEAR(ball.velocity.x, 3 + support / ball.mass, 1e-14);
            EXPECT_NEAR(ball.spin, spin + ball.radius * support / inertia(ball), 1e-13);
        }
}

TEST(Response, WhatGravityAddedSinceTheTouchIsNoImpact) {
    // Rested on the floor, then fell freely for 0.1 s at 10 m/s².
    Ball ball = ball_with({0, -1});
    const Touch deep{{0, 0}, {0, 1}, -0.05, false};
    const Impact hit = respond(ball, deep, {}, {0.9, 0, 0}, {{0, -10}, 0.01});
    EXPECT_FALSE(hit.happened);
    EXPECT_EQ(ball.velocity.y, 0);
    push_out(ball, deep);
    EXPECT_EQ(ball.position.y, 0.05);
    EXPECT_EQ(ball.velocity.y, 0);
}

TEST(Response, RestingBallRollsByFriction) {
    // Sliding at 3 m/s for 0.1 s under gravity: the friction impulse is µ·m·g·t.
    Ball ball = ball_with({3, -1});
    const Touch deep{{0, 0}, {0, 1}, -0.05, false};
    (void)respond(ball, deep, {}, {0, 0.2, 0}, {{0, -10}, 0.01});
    EXPECT_NEAR(ball.velocity.x, 3 - 0.2 * 10 * 0.1, 1e-14);
}

double energy(const Ball& ball) {
    return 0.5 * ball.mass * length_squared(ball.velocity) + 0.5 * inertia(ball) * ball.spin * ball.spin;
}
double angular_momentum(const Ball& ball) {
    return ball.mass * cross(ball.position, ball.velocity) + inertia(ball) * ball.spin;
}
double number(int least, int most) {
    return *rc::gen::inRange(least * 1000, most * 1000) * 1e-3;
}

RC_GTEST_PROP(Response, PairsConserve, ()) {
    Ball a = ball_with({number(-5, 5), number(-5, 5)}, number(-9, 9), number(1, 50), number(1, 3));
    Ball b = ball_with({number(-5, 5), number(-5, 5)}, number(-9, 9), number(1, 50), number(1, 3));
    a.position = 0.99 * (a.radius + b.radius) * from_angle(number(-3, 3));
    const bool rough = *rc::gen::arbitrary<bool>();
    const double e = *rc::gen::element(0.0, 0.5, 1.0);
    const Ball a0 = a, b0 = b;
    const double before = energy(a) + energy(b);
    const Impact hit = respond(a, b, {e, rough ? 0.5 : 0, 0}, {{0, 0}, 0});
    const Vec2 momentum = a0.mass * a0.velocity + b0.mass * b0.velocity;
    const double scale = length(a0.velocity) * a0.mass + length(b0.velocity) * b0.mass + 1e-9;
    RC_ASSERT(length(a.mass * a.velocity + b.mass * b.velocity - momentum) <= 4e-15 * scale);
    RC_ASSERT(energy(a) + energy(b) <= before * (1 + 1e-14));
    if (!hit.happened) return;
    const double apart = dot(a.velocity - b.velocity, hit.normal);
    RC_ASSERT(std::abs(apart - e * hit.speed) <= 1e-12 * (1 + hit.speed));
    if (e == 1 && !rough) RC_ASSERT(std::abs(energy(a) + energy(b) - before) <= 1e-13 * before);
    // The impulse acts along the line of centres.
    if (rough) return;
    const double turned =
        angular_momentum(a) + angular_momentum(b) - angular_momentum(a0) - angular_momentum(b0);
    RC_ASSERT(std::abs(turned) <= 1e-10 * scale);
}

TEST(Response, UnequalMassesHeadOn) {
    // v₁' = ((m₁ − e·m₂)·v₁ + (1+e)·m₂·v₂)/(m₁+m₂), up to a mass ratio of a million.
    for (const double m : {1.0, 1e3, 1e6}) {
        Ball a = ball_with({2, 0}, 0, m), b = ball_with({-1, 0}, 0, 1);
        a.position = {-1, 0};
        ASSERT_TRUE(respond(a, b, {0.8, 0, 0}, weightless).happened);
        EXPECT_NEAR(a.velocity.x, ((m - 0.8) * 2 + 1.8 * -1) / (m + 1), 1e-14);
        EXPECT_NEAR(b.velocity.x, ((1 - 0.8 * m) * -1 + 1.8 * m * 2) / (m + 1), 1e-14);
    }
}

TEST(Response, PushOutIsSharedByInverseMass) {
    Ball a = ball_with({}, 0, 3), b = ball_with({}, 0, 1);
    b.position = {0.6, 0};
    push_out(a, b, touch(a.position, a.radius, b.position, b.radius));
    EXPECT_NEAR(a.position.x, -0.1, 1e-15);
    EXPECT_NEAR(b.position.x, 0.9, 1e-15);
    EXPECT_EQ(a.velocity, Vec2{});
}

TEST(Response, ABallOfInfiniteMassStaysAsItIs) {
    Ball a = ball_with({0, -2}, 4, 1), b = ball_with({}, 0, INFINITY);
    a.position = {0, 1};
    const Impact hit = respond(a, b, {0.5, 0.2, 0}, weightless);
    EXPECT_TRUE(hit.happened);
    EXPECT_NEAR(a.velocity.y, 1, 1e-15);
    EXPECT_NE(a.spin, 4);
    EXPECT_EQ(b.velocity, Vec2{});
    EXPECT_EQ(b.spin, 0);
}

}  // namespace
}  // namespace flipside::custom
