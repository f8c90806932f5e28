#include "custom/islands/contact_solver.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "custom/between.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom::test {
namespace {

using Body = ContactSolver::Body;

constexpr Vec2 gravity{0, -9.81};
constexpr double tick = 1.0 / 240, radius = 0.1;

Body disc(Vec2 position, Vec2 velocity = {}, double mass = 1) {
    return {position, velocity, tick * gravity, 0, radius, 1 / mass, 2 / mass};
}
Body ground(Vec2 point) {
    return {point, {}, {}, 0, 0, 0, 0};
}
ContactSolver::Contact on_ground(ContactSolver& solver, ContactSolver::Index ball, Vec2 point, Vec2 normal,
                                 double gap = 0) {
    ContactSolver::Contact contact;
    contact.upper = ball;
    contact.lower = solver.add(ground(point));
    contact.normal = normal;
    contact.detected_gap = gap;
    contact.with = ContactSolver::With::still_part;
    return contact;
}
ContactSolver::Contact between_balls(const ContactSolver& solver, ContactSolver::Index upper,
                                     ContactSolver::Index lower) {
    const Vec2 apart = solver.bodies()[upper].position - solver.bodies()[lower].position;
    ContactSolver::Contact contact;
    contact.upper = upper;
    contact.lower = lower;
    contact.normal = unit(apart);
    contact.detected_gap = length(apart) - 2 * radius;
    contact.height = -dot(solver.bodies()[upper].position + solver.bodies()[lower].position, gravity);
    return contact;
}

TEST(ContactSolver, AColumnStandsFromTheFirstTick) {
    for (const int balls : {1, 2, 10, 50}) {
        ContactSolver solver;
        solver.start();
        for (int i = 0; i < balls; ++i) solver.add(disc({0, radius * (1 + 2 * i)}));
        solver.add(on_ground(solver, 0, {0, 0}, {0, 1}));
        for (int i = 1; i < balls; ++i)
            solver.add(between_balls(solver, static_cast<ContactSolver::Index>(i),
                                     static_cast<ContactSolver::Index>(i - 1)));
        solver.solve(tick, gravity);
        for (int i = 0; i < balls; ++i) {
            const Body& body = solver.bodies()[static_cast<std::size_t>(i)];
            // Sweeps end at 1e-4 of the speed that gravity gives in a tick, which shows with two balls.
            EXPECT_NEAR(length(body.velocity), 0, balls == 2 ? 1e-4 * tick * length(gravity) : 1e-11)
                << i << " of " << balls;
            EXPECT_NEAR(body.position.y, radius * (1 + 2 * i), 1e-12);
        }
    }
}

TEST(ContactSolver, BothSidesOfAWedgeSupportABall) {
    ContactSolver solver;
    solver.start();
    const Vec2 left = unit({1, 1}), right = unit({-1, 1});
    solver.add(disc({0, 0}));
    solver.add(on_ground(solver, 0, -radius * left, left));
    solver.add(on_ground(solver, 0, -radius * right, right));
    solver.solve(tick, gravity);
    EXPECT_LT(length(solver.bodies()[0].velocity), 1e-5 * 9.81);
    for (const ContactSolver::Contact& contact : solver.contacts())
        EXPECT_NEAR(contact.impulse.normal, 9.81 * tick / std::sqrt(2.0), 1e-5);
}

TEST(ContactSolver, AGapClosesAtMostToZero) {
    ContactSolver solver;
    solver.start();
    solver.add(disc({0, radius + 1e-4}, {0.3, -0.2}));
    solver.add(on_ground(solver, 0, {0, 0}, {0, 1}, 1e-4));
    solver.solve(tick, gravity);
    EXPECT_NEAR(solver.bodies()[0].velocity.y, -1e-4 / tick, 1e-12);
    EXPECT_EQ(solver.bodies()[0].velocity.x, 0.3);
}

TEST(ContactSolver, FrictionHoldsOnASlopeThatIsFlatEnough) {
    for (const double slope :
         {0.2, 0.5}) {  // the tangent; µ is 0.1: a third of the force accelerates the spin
        const Vec2 normal = unit({-slope, 1}), down = -perp(normal);
        ContactSolver solver;
        solver.start();
        solver.add(disc({0, 0}));
        ContactSolver::Contact contact = on_ground(solver, 0, -radius * normal, normal);
        contact.friction = 0.1;
        solver.add(contact);
        solver.solve(tick, gravity);
        const Body& body = solver.bodies()[0];
        const double pull = dot(gravity, down), weight = -dot(gravity, normal);
        const bool rolls = std::abs(pull) / 3 < 0.1 * weight;
        const double kept = rolls ? pull * 2 / 3 : pull - std::copysign(0.1 * weight, pull);
        EXPECT_EQ(rolls, slope < 0.3);
        EXPECT_NEAR(dot(body.velocity, down), kept * tick, 1e-7);
        if (rolls) {
            EXPECT_NEAR(dot(body.velocity, perp(normal)), body.rim_speed, 1e-9);
        }
    }
}

// For any input, the solver adds energy only to lift balls out of overlaps, changes the momentum of a pair of
// balls only by shock propagation, and leaves no ball inside a static part.
RC_GTEST_PROP(ContactSolver, HeapsGainNoEnergy, ()) {
    ContactSolver solver;
    solver.start();
    const auto balls = *rc::gen::inRange<ContactSolver::Index>(1, 25);
    for (ContactSolver::Index i = 0; i < balls; ++i)
        solver.add(disc({0.195 * (i % 5) + between(-0.002, 0.002), radius + 0.198 * (i / 5)},
                        {between(-0.1, 0.1), between(-0.1, 0.1)}, between(0.5, 2)));
    const auto energy = [&](double ahead) {
        double sum = 0;
        for (const Body& body : solver.bodies().first(balls))
            sum +=
                (0.5 * length_squared(body.velocity) - dot(gravity, body.position + ahead * body.velocity)) /
                    body.inverse_mass +
                0.5 * body.rim_speed * body.rim_speed / body.inverse_rim_mass;
        return sum;
    };
    double weight = 0;
    for (const Body& body : solver.bodies()) weight += 9.81 / body.inverse_mass;
    const double before = energy(0), friction = *rc::gen::element(0.0, 0.5);
    double deepest = 0;
    for (ContactSolver::Index i = 0; i < balls; ++i)
        for (ContactSolver::Index j = 0; j < i; ++j) {
            ContactSolver::Contact contact = between_balls(solver, i, j);
            contact.friction = friction;
            if (contact.detected_gap > 1e-3) continue;
            deepest = std::max(deepest, -contact.detected_gap);
            solver.add(contact);
        }
    for (ContactSolver::Index i = 0; i < std::min(balls, ContactSolver::Index{5}); ++i)
        solver.add(on_ground(solver, i, {solver.bodies()[i].position.x, 0}, {0, 1}));
    solver.solve(tick, gravity);
    RC_ASSERT(energy(tick) <= before + weight * 5 * deepest + 1e-9);
    for (ContactSolver::Index i = 0; i < std::min(balls, ContactSolver::Index{5}); ++i) {
        const Body& body = solver.bodies()[i];
        RC_ASSERT(body.position.y + tick * body.velocity.y >= radius - 1e-9);
    }
}

// Something must overlap: the part that moves, and not the walls.
TEST(ContactSolver, APartThatMovesDoesNotPressABallIntoTheWallsOfAWedge) {
    const Vec2 left{1, 0}, right{-0.8, 0.6}, down{0, -1};
    ContactSolver solver;
    solver.start();
    const ContactSolver::Index ball = solver.add(disc({}));
    solver.add(on_ground(solver, ball, -radius * left, left));
    solver.add(on_ground(solver, ball, -radius * right, right));
    ContactSolver::Contact part = on_ground(solver, ball, -radius * down, down, -0.5 * radius);
    part.with = ContactSolver::With::moving_part;
    part.lower = solver.add({-radius * down, 20 * down, {}, 0, 0, 0, 0});
    solver.add(part);
    solver.solve(tick, gravity);
    const Body& body = solver.bodies()[ball];
    for (const Vec2 normal : {left, right}) {
        EXPECT_GE(dot(body.position, normal), -corrected_overlap * radius);
        EXPECT_GE(dot(body.velocity, normal), -length(gravity) * tick);
    }
}

}  // namespace
}  // namespace flipside::custom::test
