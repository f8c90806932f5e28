#include "world/clock.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

// Steps may be far below the rounding of the time: they add up in the remainder, without loss.
RC_GTEST_PROP(Clock, NeverRunsBackwardsNorLosesAStep, ()) {
    constexpr double unit = 0x1p-50;       // s; all steps are multiples of it, so that sums are exact
    __extension__ typedef __int128 Units;  // NOLINT(modernize-use-using)
    const auto start = static_cast<double>(
        *rc::gen::element<std::int64_t>(0, 1, 16'667, 1'000'000'000'000, 1'000'000'000'000'000));
    Clock clock{start, 0};
    Units exact = static_cast<Units>(start / unit);
    const int longest = *rc::gen::inRange(1, 31);
    for (int i = 0; i < 1000; ++i) {
        const int step = *rc::gen::resize(1000, rc::gen::inRange(1, (1 << (longest - 1)) + 1));
        const double before = clock.time;
        clock.advance(step * unit);
        exact += step;
        RC_ASSERT(clock.time >= before);
        RC_ASSERT(std::abs(clock.remainder) <= (std::nextafter(clock.time, INFINITY) - clock.time) / 2);
        RC_ASSERT(static_cast<Units>(clock.time / unit) + static_cast<Units>(clock.remainder / unit) ==
                  exact);
    }
}

}  // namespace
}  // namespace flipside
