#pragma once
/// Roots: the first time at which a function of time falls to zero. A closed form for
/// polynomials up to degree two; Newton steps between bracketed extrema up to degree four, and for a line
/// under drag; for other functions bisection, regula falsi, or safe steps.

#include <algorithm>
#include <array>
#include <cmath>

#include "world/vec2.hpp"

namespace flipside::custom {

inline constexpr double never_touch = INFINITY;

/// First t ≥ 0 at which gap + rate·t + ½·bend·t² is ≤ 0 and decreasing, or never_touch. A negative gap that
/// increases does not count until it decreases again.
[[nodiscard]] double first_crossing(double gap, double rate, double bend);
/// The same for gap + rate·E(t) + bend·F(t) (flight.hpp); with drag by about four Newton steps.
[[nodiscard]] double first_crossing(double gap, double rate, double bend, double drag);
/// Inverse of E: the t at which E(t) = e; infinite if drag stops the motion before.
inline double drag_time(double c, double e) {
    if (c <= 0) return e;
    return c * e < 1 ? -math::log1p(-c * e) / c : INFINITY;
}

/// The t at which v₀·e^(−ct) + a·E(t) is 0, for v₀ and a of opposite signs.
inline double drag_turn(double v, double a, double c) {
    return c > 0 ? math::log1p(-c * v / a) / c : -v / a;
}
/// Time for which a function ≥ 0 stays so at least, given its slope and K ≥ |second derivative|.
[[nodiscard]] double safe_time(double value, double slope, double k);

/// c[0] + c[1]·t + … + c[4]·t⁴.
using Quartic = std::array<double, 5>;

/// |p + v·t + ½a·t²|² − reach², in m²: two discs with different constant accelerations touch where it is 0.
[[nodiscard]] Quartic squared_gap(Vec2 p, Vec2 v, Vec2 a, double reach);

/// First t in [0, until] at which the polynomial is ≤ 0 and decreasing, or never_touch. A negative value at 0
/// does not count until the polynomial has begun to decrease again. The polynomial is monotone between the
/// roots of its derivative, which the roots of the second derivative bracket; so no root is missed. Cost: up
/// to four Newton searches of about six steps.
[[nodiscard]] double first_crossing(const Quartic& c, double until);

/// Bisection to neighbouring numbers: `is_before` is true at a and false at b, and the result is the first
/// number at which it is found false. 1,100 passes suffice for any a and b, since each halves the count of
/// numbers between them once their exponents are equal.
double turning_point(auto&& is_before, double a, double b, int most_halvings = 1100) {
    for (int i = 0; i < most_halvings; ++i) {
        const double middle = a + (b - a) / 2;
        if (middle <= a || middle >= b) break;
        (is_before(middle) ? a : b) = middle;
    }
    return b;
}

/// Root of f in (a, b], where f(a) > 0 ≥ f(b); the result is at most `error` behind it. The Illinois
/// algorithm (Dowell and Jarratt 1971, "A modified regula falsi method for computing the root of an
/// equation"): chords, and the value at an end that is kept twice is halved. It takes about ten steps; after
/// `most_chords` it bisects, at most 1,100 times.
double first_zero(auto&& f, double a, double f_a, double b, double f_b, double error) {
    constexpr int most_chords = 100;
    int kept = 0;  // how often in a row b (above 0) or a (below 0) was kept
    for (int step = 0; b - a > error; ++step) {
        if (a + (b - a) / 2 <= a || a + (b - a) / 2 >= b) break;
        const double chord = a + (b - a) * (step < most_chords ? f_a / (f_a - f_b) : 0.5);
        const double middle = std::max(a + error / 2, std::min(chord, b - error / 2));
        const double value = f(middle);
        if (value <= 0) {
            b = middle, f_b = value;
            kept = std::min(kept, 0) - 1;
            if (kept < -1) f_a /= 2;
        } else {
            a = middle, f_a = value;
            kept = std::max(kept, 0) + 1;
            if (kept > 1) f_b /= 2;
        }
    }
    return b;
}

}  // namespace flipside::custom
