// Roots of polynomials made from known roots; nothing lost, nothing invented.

#include "reference/polynomial.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace flipside::reference {
namespace {

/// lead·Π(t − r).
template <class R>
Polynomial<R> from_roots(const std::vector<double>& roots, double lead) {
    Polynomial<R> f{};
    f.c[0] = R(lead);
    for (std::size_t n = 0; n < roots.size(); ++n)
        for (std::size_t k = n + 2; k-- > 0;) f.c[k] = (k > 0 ? f.c[k - 1] : R(0)) - R(roots[n]) * f.c[k];
    return f;
}

template <class R>
void expect_roots(const std::vector<double>& wanted, double lead, double tolerance) {
    const Roots<R> found = roots(from_roots<R>(wanted, lead), R(0), R(10));
    ASSERT_EQ(found.count, static_cast<int>(wanted.size()));
    for (std::size_t i = 0; i < wanted.size(); ++i)
        EXPECT_NEAR(static_cast<double>(found.at[i]), wanted[i], tolerance);
}

RC_GTEST_PROP(Polynomial, EveryRootIsFoundOnce, ()) {
    const auto degree = *rc::gen::inRange<std::size_t>(1, 5);
    const double lead = *rc::gen::inRange(1, 100) * (*rc::gen::arbitrary<bool>() ? 1.0 : -1.0);
    std::vector<double> wanted;
    for (std::size_t i = 0; i < degree; ++i)
        wanted.push_back(0.1 + 2 * static_cast<double>(i) + *rc::gen::inRange(0, 1000) / 600.0);
    const Roots<double> found = roots(from_roots<double>(wanted, lead), 0.0, 10.0);
    RC_ASSERT(found.count == static_cast<int>(degree));
    for (std::size_t i = 0; i < degree; ++i) RC_ASSERT(std::abs(found.at[i] - wanted[i]) < 1e-9);
}

RC_GTEST_PROP(Polynomial, FallsAreTheRootsWhereItGoesDown, ()) {
    std::vector<double> wanted;
    for (int i = 0; i < 4; ++i) wanted.push_back(0.1 + 2 * i + *rc::gen::inRange(0, 1000) / 600.0);
    const FallingRoots<double> found = falling_roots(from_roots<double>(wanted, 1), 10.0, 1e-12);
    // Positive before the first root: it falls through the first and the third.
    RC_ASSERT(found.count == 2);
    RC_ASSERT(std::abs(found.at[0] - wanted[0]) < 1e-9);
    RC_ASSERT(std::abs(found.at[1] - wanted[2]) < 1e-9);
}

TEST(Polynomial, LeadingZerosAreNoDegree) {
    const Polynomial<double> line{{3, -2, 0, 0, 0}};
    const Roots<double> one = roots(line, 0.0, 10.0);
    ASSERT_EQ(one.count, 1);
    EXPECT_EQ(one.at[0], 1.5);
    EXPECT_EQ(roots(Polynomial<double>{{1, 0, 0, 0, 0}}, 0.0, 10.0).count, 0);
    EXPECT_EQ(roots(Polynomial<double>{{1, 0, 1, 0, 0}}, -10.0, 10.0).count, 0);
}

TEST(Polynomial, ClustersAreToldApartAsFarAsThePrecisionGoes) {
    expect_roots<double>({1, 1.001, 1.002, 1.003}, 1, 1e-6);
    expect_roots<Real113>({1, 1.000001, 1.000002, 1.000003}, 1, 1e-12);
    expect_roots<Real226>({1, 1 + 1e-10, 1 + 2e-10, 1 + 3e-10}, 1, 1e-15);
}

TEST(Polynomial, ADoubleRootGrazes) {
    // (t − 1)²: exactly touching, in numbers that hold it exactly.
    EXPECT_TRUE(falling_roots(Polynomial<double>{{1, -2, 1, 0, 0}}, 10.0, 1e-12).grazes);
    EXPECT_FALSE(falling_roots(Polynomial<double>{{1 + 1e-9, -2, 1, 0, 0}}, 10.0, 1e-12).grazes);
    EXPECT_EQ(falling_roots(Polynomial<double>{{1 - 1e-9, -2, 1, 0, 0}}, 10.0, 1e-12).count, 1);
}

TEST(Polynomial, OverlapsFollowTheirRules) {
    // Overlapping and approaching: now. Receding: not until it turns.
    const FallingRoots<double> now = falling_roots(Polynomial<double>{{-1e-3, -1, 0, 0, 0}}, 10.0, 1e-12);
    ASSERT_EQ(now.count, 1);
    EXPECT_EQ(now.at[0], 0);
    EXPECT_EQ(falling_roots(Polynomial<double>{{-1e-3, 1, 0, 0, 0}}, 10.0, 1e-12).count, 0);
    const FallingRoots<double> turns = falling_roots(Polynomial<double>{{-1, 1, -0.5, 0, 0}}, 10.0, 1e-12);
    ASSERT_EQ(turns.count, 1);
    EXPECT_NEAR(turns.at[0], 1, 1e-9);
}

}  // namespace
}  // namespace flipside::reference
