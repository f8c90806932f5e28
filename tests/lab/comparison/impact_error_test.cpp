#include "lab/comparison/impact_error.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "lab/comparison/impact.hpp"

namespace flipside::lab {
namespace {

TEST(ImpactError, IsWhatDiffers) {
    Event exact = impact(1, 0, 2), other = impact(1.017, 0, 2);
    exact.normal = {0, 1};
    exact.point = {0.5, 0};
    exact.speed = 2;
    other.normal = from_angle(0.5 * std::numbers::pi + 0.03);
    other.point = {0.5, 0.004};
    other.speed = 1.75;
    const ImpactError error = error_of(other, exact);
    EXPECT_NEAR(error.late, 0.017, 1e-15);
    EXPECT_NEAR(error.normal, 0.03, 1e-15);
    EXPECT_NEAR(error.distance, 0.004, 1e-15);
    EXPECT_EQ(error.speed, -0.25);
    EXPECT_NEAR(error_of(exact, other).normal, 0.03, 1e-15);
    other.normal = {0, -1};
    EXPECT_NEAR(error_of(other, exact).normal, std::numbers::pi, 1e-15);
}

}  // namespace
}  // namespace flipside::lab
