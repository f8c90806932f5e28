#include "custom/geometry/roots.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "custom/between.hpp"

namespace flipside::custom::test {
namespace {

double value(const Quartic& c, double t) {
    return (((c[4] * t + c[3]) * t + c[2]) * t + c[1]) * t + c[0];
}

// The first change of sign from above 0 to below, against an evaluation at ten thousand instants.
RC_GTEST_PROP(Quartic, FirstCrossingIsTheFirst, ()) {
    const Vec2 p{between(-2, 2), between(-2, 2)}, v{between(-3, 3), between(-3, 3)};
    const Vec2 a{between(-9, 9), between(-9, 9)};
    const double reach = between(0.1, 1), until = 2;
    RC_PRE(length(p) > reach);
    const Quartic gap = squared_gap(p, v, a, reach);
    const double found = first_crossing(gap, until);
    constexpr int looks = 10'000;
    double seen = INFINITY;
    for (int i = 0; i <= looks && seen == INFINITY; ++i)
        if (value(gap, until * i / looks) < -1e-6) seen = until * i / looks;
    if (seen < INFINITY) RC_ASSERT(found <= seen);
    if (found == INFINITY) return;
    const Vec2 at = p + found * v + 0.5 * found * found * a, speed = v + found * a;
    RC_ASSERT(std::abs(length(at) - reach) <= 1e-9);
    RC_ASSERT(dot(at, speed) <= 1e-9);
    for (int i = 0; i < 1000; ++i) RC_ASSERT(value(gap, found * i / 1000) > -1e-9);
}

TEST(Quartic, FirstCrossingFromZero) {
    // In contact and separating, with a constant acceleration back: the discs meet again 2 s later.
    const Quartic gap = squared_gap({1, 0}, {1, 0}, {-1, 0}, 1);
    EXPECT_NEAR(first_crossing(gap, 3), 2, 1e-14);
    EXPECT_EQ(first_crossing(gap, 1.9), INFINITY);
    EXPECT_EQ(first_crossing(squared_gap({1, 0}, {-1, 0}, {0, 0}, 1), 1), 0);
}

}  // namespace
}  // namespace flipside::custom::test
