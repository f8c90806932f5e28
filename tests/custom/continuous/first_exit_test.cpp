#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "custom/between.hpp"
#include "custom/continuous/time_of_impact.hpp"
#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

constexpr Box unit_box{{0, 0}, {1, 1}};

Path flight(Vec2 position, Vec2 velocity, Vec2 acceleration, double drag = 0) {
    Path path;
    path.flight = {position, velocity, acceleration, drag};
    return path;
}

// Conservative advancement with bounds on speed and acceleration, to compare with.
double exit_by_steps(const Path& path, double t1) {
    const double k = path.max_acceleration(t1);
    double t = 0;
    for (int step = 0; step < 100'000 && t <= t1; ++step) {
        const auto [p, v] = path.at(t);
        if (!unit_box.contains(p)) return t;
        t += std::max(1e-12, std::min({safe_time(p.x, v.x, k), safe_time(1 - p.x, -v.x, k),
                                       safe_time(p.y, v.y, k), safe_time(1 - p.y, -v.y, k)}));
    }
    return never_touch;
}

RC_GTEST_PROP(FirstExit, AgreesWithConservativeAdvancement, ()) {
    const Path path = flight({between(0, 1), between(0, 1)}, {between(-5, 5), between(-5, 5)},
                             {between(-9, 9), between(-9, 9)}, *rc::gen::element(0.0, 0.3, 40.0));
    const double expected = exit_by_steps(path, 2), t = first_exit(path, unit_box, 0, 2);
    RC_ASSERT((expected == never_touch) == (t == never_touch));
    if (t == never_touch) return;
    RC_ASSERT(std::abs(t - expected) <= 1e-9);
    // The path is inside up to the last number before it, and outside there.
    RC_ASSERT(!unit_box.contains(path.position(t)));
    RC_ASSERT(t == 0 || unit_box.contains(path.position(std::nextafter(t, 0))));
}

// The border is inside; the ball is lost at the first representable time at which it is outside.
TEST(FirstExit, FromTheBorder) {
    EXPECT_EQ(first_exit(flight({0, 0.5}, {0, 0.1}, {0, -1}, 0.5), unit_box, 0, 1), never_touch);
    EXPECT_EQ(first_exit(flight({1, 1}, {}, {}), unit_box, 0, 1), never_touch);
    EXPECT_EQ(first_exit(flight({0, 0.5}, {0.1, 0}, {}), unit_box, 0, 1), never_touch);
    EXPECT_LT(first_exit(flight({0, 0.5}, {-1e-3, 0}, {}), unit_box, 0, 1), 1e-300);
    EXPECT_LT(first_exit(flight({1, 0.5}, {}, {1e-3, 0}), unit_box, 0, 1), 1e-6);
    EXPECT_LT(first_exit(flight({1, 1}, {-1, 0}, {0, 10}), unit_box, 0, 1), 1e-7);
    EXPECT_EQ(first_exit(flight({1.5, 1}, {-1, 0}, {}), unit_box, 0, 1), 0);
    EXPECT_NEAR(first_exit(flight({0, 0.5}, {1, 0}, {-4, 0}), unit_box, 0, 1), 0.5, 1e-15);
}

// At the end of the interval, also for a late start of the path, where times are rounded.
TEST(FirstExit, AtTheEnd) {
    Path path = flight({0.5, 0.5}, {0.5 / (0.7 - 0.1), 0}, {});
    path.start = 0.1;
    double end = 0.7;
    while (unit_box.contains(path.position(end))) end = std::nextafter(end, 1);
    EXPECT_EQ(first_exit(path, unit_box, 0.1, end), end);
    EXPECT_EQ(first_exit(path, unit_box, 0.1, std::nextafter(end, 0)), never_touch);
}

// A parabola whose apex touches the border stays inside; one slightly higher leaves.
TEST(FirstExit, Grazes) {
    EXPECT_EQ(first_exit(flight({0.5, 0.5}, {0, 1}, {0, -1}), unit_box, 0, 1.5), never_touch);
    EXPECT_NEAR(first_exit(flight({0.5, 0.5}, {0, 1 + 1e-12}, {0, -1}), unit_box, 0, 1.5), 1, 2e-6);
}

/// x(t) = Σ series[k]·t^k, y = ½.
Path polynomial(std::initializer_list<double> series) {
    Path path;
    TaylorPath& taylor = path.taylor.emplace_back();
    int k = 0;
    for (const double c : series) {
        if (k == 0)
            path.flight.position = {c, 0.5};
        else
            taylor.displacement[k] = {c, 0};
        ++k;
    }
    return path;
}

TEST(FirstExit, OfAPolynomial) {
    // 1 − (t − ¼)²·(t − ½)² touches the border twice.
    const double a = 1.0 / 64, b = -3.0 / 16, c = 13.0 / 16, d = -1.5;
    EXPECT_EQ(first_exit(polynomial({1 - a, -b, -c, -d, -1}), unit_box, 0, 1), never_touch);
    EXPECT_NEAR(first_exit(polynomial({1 - a + 1e-9, -b, -c, -d, -1}), unit_box, 0, 1), 0.25, 2e-4);
    EXPECT_EQ(first_exit(polynomial({1}), unit_box, 0, 1), never_touch);
    EXPECT_EQ(first_exit(polynomial({0, 0, 0, 0, 1}), unit_box, 0, 1), never_touch);
    EXPECT_NEAR(first_exit(polynomial({0.5, 0, 0, 0, 8}), unit_box, 0, 1), 0.5, 1e-15);
}

}  // namespace
}  // namespace flipside::custom::test
