#include "custom/flight.hpp"

#include <gtest/gtest.h>

#include "custom/geometry/roots.hpp"

namespace flipside::custom {
namespace {

TEST(Flight, ManyShortOnesMakeOneLong) {
    for (const double damping : {0.0, 1e-7, 1e-3, 0.2, 0.99, 1.01, 5.0}) {
        const Vec2 gravity{0.3, -9.81};
        Ball once, often;
        once.velocity = often.velocity = {1, 2};
        once.spin = often.spin = 3;
        fly_freely(once, gravity, TimeInterval(damping, 1));
        for (int i = 0; i < 100; ++i) fly_freely(often, gravity, TimeInterval(damping, 0.01));
        EXPECT_LT(length(once.position - often.position), 1e-13) << damping;
        EXPECT_LT(length(once.velocity - often.velocity), 1e-13) << damping;
        EXPECT_NEAR(once.angle, 3, 1e-15);
        EXPECT_NEAR(often.angle, 3, 1e-13);
    }
}

TEST(Flight, DampedFallApproachesItsLimit) {
    Ball ball;
    fly_freely(ball, {0, -9.81}, TimeInterval(2, 50));
    EXPECT_NEAR(ball.velocity.y, -9.81 / 2, 1e-14);
}

// Against long double, on both sides of every change of formula.
TEST(Flight, FactorsAreGoodToRounding) {
    for (const double x : {0.0, 1e-12, 1e-6, 0.00399, 0.00401, 0.1, 0.499, 0.501, 1.0, 5.0}) {
        const long double y = x, e = std::expm1(-y);
        long double phi = 0.5L, term = 0.5L;
        for (int k = 3; k < 40 && x <= 1; ++k) phi += term *= -y / k;
        if (x > 1) phi = (y + e) / (y * y);
        const TimeInterval s(x, 1);
        EXPECT_NEAR(s.fallen, static_cast<double>(phi), 4e-16) << x;
        EXPECT_NEAR(s.shrunk, static_cast<double>(1 - y * phi), 4e-16) << x;
        EXPECT_NEAR(s.kept, static_cast<double>(1 + e), 4e-16) << x;
        EXPECT_NEAR(drag_time(x, s.shrunk), 1, 1e-13) << x;
    }
}

}  // namespace
}  // namespace flipside::custom
