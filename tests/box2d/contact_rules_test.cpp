#include <gtest/gtest.h>

#include "box2d/table_top.hpp"
#include "world/gate.hpp"

// Without gravity every answer is known; single precision and a solver that divides by its effective mass
// leave about 1e-6 relative. Friction is less exact: Box2D lets it act midway between the surfaces, which
// overlap by up to 3 slops (0.015 units, 6 % of the radius) at the moment of a hit.

namespace flipside::box2d::test {
namespace {

struct Weightless : TableTop {
    Weightless() { scene.gravity = {}; }
    /// The ball's velocity after 0.2 s.
    Ball later(double seconds = 0.2) const {
        const auto w = world();
        run(*w, seconds);
        return w->balls()[0];
    }
};

TEST(ContactRules, restitutionIsTheProduct) {
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5));
    top.ball({0, 0.05}, {0.3, -1}, top.material(0.9));
    const Ball ball = top.later();
    EXPECT_NEAR(ball.velocity.y, 0.45, 1e-5);
    EXPECT_NEAR(ball.velocity.x, 0.3, 1e-6);
    EXPECT_EQ(ball.spin, 0);
}

TEST(ContactRules, restitutionMayExceedOne) {
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(1.5));
    top.ball({0, 0.05}, {0, -1});
    EXPECT_NEAR(top.later().velocity.y, 1.5, 1e-5);
}

TEST(ContactRules, frictionIsTheGeometricMeanAndSlides) {
    // J_t = µ·J_n = µ(1+e)m·v_n, below sticking; the spin takes r·J_t over ½mr².
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5, 0.25));
    top.ball({0, 0.05}, {1, -1}, top.material(1, 0.04));
    const Ball ball = top.later();
    const double change = 0.1 * 1.5;
    EXPECT_NEAR(ball.velocity.x, 1 - change, 1e-4);
    EXPECT_NEAR(ball.spin, -2 * change / radius, 0.03 * 2 * change / radius);
}

TEST(ContactRules, frictionIsCappedAtSticking) {
    // J_t = m·v_t/3 stops the slip of a disc.
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5, 1));
    top.ball({0, 0.05}, {0.6, -1}, top.material(1, 1));
    const Ball ball = top.later();
    EXPECT_NEAR(ball.velocity.x, 0.4, 0.03 * 0.4);
    EXPECT_NEAR(ball.velocity.x + radius * ball.spin, 0, 0.03 * 0.4);
}

TEST(ContactRules, spinIsKeptWithoutFriction) {
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5, 0));
    top.ball({0, 0.05}, {0.6, -1}, top.material(1, 1)).spin = 7;
    EXPECT_FLOAT_EQ(static_cast<float>(top.later().spin), 7);
}

TEST(ContactRules, slowApproachDoesNotBounce) {
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.8, 0, 2));
    top.ball({0, radius + 0.0005}, {0, -0.009});
    top.scene.rest_speed = 0.01;
    EXPECT_NEAR(top.later().velocity.y, 0, 1e-6);
    top.scene.rest_speed = 0.008;
    EXPECT_NEAR(top.later().velocity.y, 2, 1e-4);
}

TEST(ContactRules, kickIsTheLeastOutgoingSpeed) {
    Weightless top;
    top.part(shape::Circle{{0, 0}, 0.03}, top.material(0.8, 0, 2));
    top.ball({0, 0.1}, {0, -1});
    EXPECT_NEAR(top.later().velocity.y, 2, 1e-4);
    top.scene.balls[0].velocity.y = -4;
    EXPECT_NEAR(top.later().velocity.y, 3.2, 1e-4);
}

TEST(ContactRules, gateReflectsAgainstItsNormal) {
    Weightless top;
    top.part(shape::Gate{{-0.1, 0}, {0.1, 0}, {0, 1}}, top.material(0.5));
    top.ball({0, 0.05}, {0, -1});
    EXPECT_NEAR(top.later().velocity.y, 0.5, 1e-5);
}

TEST(ContactRules, gatePassesAlongItsNormalAndStaysOpenWhileOccupied) {
    for (const double speed : {0.05, 1.0, 6.0}) {
        Weightless top;
        top.part(shape::Gate{{-0.1, 0}, {0.1, 0}, {0, 1}}, top.material(0.5));
        top.ball({0, -0.02}, {0, speed});
        const auto world = top.world();
        run(*world, 0.05 / speed + frame, [&] {
            const double y = world->balls()[0].position.y;
            if (y < -radius - 1e-6 || y > radius + 1e-6) {
                EXPECT_FALSE(world->parts()[0].open) << y;
            }
            EXPECT_EQ(count(world->events(), EventKind::impact), 0);
            EXPECT_TRUE(world->contacts().empty());
        });
        EXPECT_GT(world->balls()[0].position.y, radius);
        EXPECT_NEAR(world->balls()[0].velocity.y, speed, 1e-6);
    }
}

// What begins deep in a gate is on its way through, whichever side its centre is on.
TEST(ContactRules, gatePassesWhatBeginsDeepInIt) {
    for (const double share : {-0.9, -0.4, 0.0, 0.4, 0.9}) {
        Weightless top;
        top.part(shape::Gate{{-0.1, 0}, {0.1, 0}, {0, 1}});
        top.ball({0, share * radius}, {0, -1});
        const auto world = top.world();
        run(*world, 0.05, [] {});
        const bool is_deep = std::abs(share) < 0.5, is_behind = share < 0;
        EXPECT_EQ(world->balls()[0].velocity.y < 0, is_deep || is_behind) << share;
    }
}

// A fast ball can end a step deep in a gate before Box2D has made a contact. A saved state says then whether
// the gate is open, so that a restored world goes on alike.
TEST(ContactRules, gateDecidesAboutWhatAStepMovesDeepIntoIt) {
    int deep = 0;
    for (const double side : {1.0, -1.0})
        for (int i = 0; i < 40; ++i) {
            Weightless top;
            top.part(shape::Gate{{-0.1, 0}, {0.1, 0}, {0, 1}});
            top.ball({0, side * (0.1 + 0.001 * i)}, {0, -side * 6});
            Settings settings(engine().settings);
            settings.set("continuous", "off");
            const auto world = top.world(settings), restored = top.world(settings);
            run(*world, 0.1, [&] {
                const State state = world->save();
                restored->restore(state);
                EXPECT_EQ(restored->save(), state);
                if (std::abs(state.balls[0].position.y) > deep_in_gate * radius) return;
                ++deep;
                EXPECT_TRUE(state.parts[0].open || !state.blocked.empty()) << state.balls[0].position.y;
            });
        }
    EXPECT_GE(deep, 5);
}

TEST(ContactRules, gateLetsABallTurnBackInside) {
    Weightless top;
    top.part(shape::Gate{{-0.1, 0}, {0.1, 0}, {0, 1}});
    top.ball({0, -0.02}, {0, 0.3});
    top.scene.gravity = {0, -3};  // turns round at y = −0.005, inside
    const auto world = top.world();
    bool opened = false;
    run(*world, 0.3, [&] { opened = opened || world->parts()[0].open; });
    EXPECT_TRUE(opened);
    EXPECT_LT(world->balls()[0].position.y, -0.02);
    EXPECT_FALSE(world->parts()[0].open);
}

TEST(ContactRules, gateEndsAreSolidToWhatComesFromTheFront) {
    for (const double side : {1.0, -1.0}) {
        Weightless top;
        top.part(shape::Gate{{-0.1, 0}, {0.1, 0}, {0, 1}});
        top.ball({0.1 + 0.5 * radius, side * 0.05}, {0, -side});
        // Met at 30 degrees: turned by 120. A step late, so only about.
        const Vec2 after = top.later().velocity;
        EXPECT_NEAR(after.x, side > 0 ? std::sqrt(0.75) : 0, 0.3);
        EXPECT_NEAR(after.y, side > 0 ? 0.5 : 1, 0.3);
    }
}

TEST(ContactRules, layersThatDoNotMeetPass) {
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}).layer = 1U << 20;
    Ball& ball = top.ball({0, 0.05}, {0, -1});
    EXPECT_NEAR(top.later().velocity.y, 1, 1e-5);
    ball.collides_with = ~(1U << 20);
    EXPECT_NEAR(top.later().velocity.y, -1, 1e-6);
    ball.collides_with = ~0U;
    ball.layer = 1U << 3;
    top.scene.parts[0].collides_with = ~(1U << 3);
    EXPECT_NEAR(top.later().velocity.y, -1, 1e-6);
}

TEST(ContactRules, impactIsReportedOnceWithItsMeasures) {
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5));
    top.ball({0.2, 0.05}, {0, -1});
    const auto world = top.world();
    std::vector<Event> impacts;
    run(*world, 0.2, [&] {
        for (const Event& event : world->events())
            if (event.kind == EventKind::impact) impacts.push_back(event);
    });
    ASSERT_EQ(impacts.size(), 1U);
    const Event& impact = impacts[0];
    EXPECT_EQ(impact.ball, 0U);
    EXPECT_EQ(impact.other, Other::part(0));
    EXPECT_NEAR(impact.time, (0.05 - radius) / 1, frame + 1e-3);
    EXPECT_NEAR(impact.speed, 1, 1e-6);
    EXPECT_NEAR(impact.impulse, 1.5 * 0.08, 1e-6);
    EXPECT_NEAR(impact.normal.y, 1, 1e-6);
    EXPECT_NEAR(impact.point.x, 0.2, 1e-6);
    EXPECT_NEAR(impact.point.y, 0, 1e-6);
}

TEST(ContactRules, ballsExchangeByMassAndTheLowerNumberIsNamed) {
    // v₁' = ((m₁ − e·m₂)v₁ + (1+e)m₂v₂)/(m₁+m₂)
    Weightless top;
    const std::uint32_t material = top.material(0.9);  // e = 0.81
    top.ball({-0.05, 0}, {1, 0}, material);
    top.ball({0.05, 0}, {-0.5, 0}, material).mass = 0.2;
    const auto world = top.world();
    std::vector<Event> impacts;
    run(*world, 0.2, [&] {
        for (const Event& event : world->events())
            if (event.kind == EventKind::impact) impacts.push_back(event);
    });
    const double e = 0.81, m1 = 0.08, m2 = 0.2, sum = m1 + m2;
    EXPECT_NEAR(world->balls()[0].velocity.x, ((m1 - e * m2) * 1 + (1 + e) * m2 * -0.5) / sum, 1e-5);
    EXPECT_NEAR(world->balls()[1].velocity.x, ((m2 - e * m1) * -0.5 + (1 + e) * m1 * 1) / sum, 1e-5);
    ASSERT_EQ(impacts.size(), 1U);
    EXPECT_EQ(impacts[0].ball, 0U);
    EXPECT_EQ(impacts[0].other, Other::ball(1));
    EXPECT_NEAR(impacts[0].normal.x, -1, 1e-6);
    EXPECT_NEAR(impacts[0].speed, 1.5, 1e-6);
    EXPECT_NEAR(impacts[0].impulse, (1 + e) * m1 * m2 / sum * 1.5, 1e-6);
}

TEST(ContactRules, targetFallsWhenHitUntilItIsRaised) {
    Weightless top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}).target = true;
    top.ball({0, 0.05}, {0, -1});
    top.ball({0.5, 0.3}, {0, -1});
    const auto world = top.world();
    run(*world, 0.1);
    EXPECT_TRUE(world->parts()[0].down);
    EXPECT_NEAR(world->balls()[0].velocity.y, 1, 1e-5);
    run(*world, 0.4);
    EXPECT_NEAR(world->balls()[1].velocity.y, -1, 1e-6);
    world->apply(control::RaiseTargets{});
    EXPECT_FALSE(world->parts()[0].down);
    Ball third = top.scene.balls[0];
    EXPECT_EQ(world->add(third), 2U);
    run(*world, 0.1);
    EXPECT_NEAR(world->balls()[2].velocity.y, 1, 1e-5);
}

}  // namespace
}  // namespace flipside::box2d::test
