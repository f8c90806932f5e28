#include "custom/discrete/flight.hpp"

#include <gtest/gtest.h>

namespace flipside::custom {
namespace {

TEST(Flight, ManyShortOnesMakeOneLong) {
    for (const double damping : {0.0, 1e-7, 1e-3, 0.2, 0.99, 1.01, 5.0}) {
        const Vec2 gravity{0.3, -9.81};
        Ball once, often;
        once.velocity = often.velocity = {1, 2};
        once.spin = often.spin = 3;
        Flight(gravity, damping, 1).advance(once);
        for (int i = 0; i < 100; ++i) Flight(gravity, damping, 0.01).advance(often);
        EXPECT_LT(length(once.position - often.position), 1e-13) << damping;
        EXPECT_LT(length(once.velocity - often.velocity), 1e-13) << damping;
        EXPECT_NEAR(once.angle, 3, 1e-15);
        EXPECT_NEAR(often.angle, 3, 1e-13);
    }
}

TEST(Flight, DampedFallApproachesItsLimit) {
    Ball ball;
    Flight({0, -9.81}, 2, 50).advance(ball);
    EXPECT_NEAR(ball.velocity.y, -9.81 / 2, 1e-14);
}

}  // namespace
}  // namespace flipside::custom
