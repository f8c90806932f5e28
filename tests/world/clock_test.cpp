#include "world/clock.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace flipside {
namespace {

TEST(Clock, AMillionStepsAreOffByOneRoundingAtMost) {
    Clock clock;
    double plain = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        clock.advance(1.0 / 60);
        plain += 1.0 / 60;
    }
    const auto exact = static_cast<double>(1'000'000.0L * static_cast<long double>(1.0 / 60));
    EXPECT_NEAR(clock.time, exact, 2e-12);      // one unit in the last place of 16667
    EXPECT_GT(std::abs(plain - exact), 2e-12);  // which the plain sum is not
}

}  // namespace
}  // namespace flipside
