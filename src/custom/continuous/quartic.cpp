#include "custom/continuous/quartic.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::custom {

namespace {

double value(const Quartic& c, double t) {
    return (((c[4] * t + c[3]) * t + c[2]) * t + c[1]) * t + c[0];
}
double slope(const Quartic& c, double t) {
    return ((4 * c[4] * t + 3 * c[3]) * t + 2 * c[2]) * t + c[1];
}
double bend(const Quartic& c, double t) {
    return (12 * c[4] * t + 6 * c[3]) * t + 2 * c[2];
}

/// Root of a monotone function with different signs at `low` and `high`: Newton steps, and bisection where
/// these would leave the bracket.
double root_between(double low, double high, auto&& f, auto&& f_slope) {
    const bool falls = f(low) > 0;
    double t = (low + high) / 2;
    constexpr int most_steps = 100;  // about six; bisection alone needs 53
    for (int step = 0; step < most_steps; ++step) {
        const double now = f(t);
        ((now > 0) == falls ? low : high) = t;
        double next = t - now / f_slope(t);
        if (!(next > low && next < high)) next = (low + high) / 2;
        if (next == t || next <= low || next >= high) return next;
        t = next;
    }
    return t;
}

}  // namespace

Quartic squared_gap(Vec2 p, Vec2 v, Vec2 a, double reach) {
    const double distance = length(p);
    return {(distance - reach) * (distance + reach), 2 * dot(p, v), length_squared(v) + dot(p, a), dot(v, a),
            length_squared(a) / 4};
}

double first_crossing(const Quartic& c, double until) {
    const auto f = [&](double t) { return value(c, t); };
    const auto df = [&](double t) { return slope(c, t); };
    const auto ddf = [&](double t) { return bend(c, t); };

    // The slope is monotone between these, the roots of 6c₄·t² + 3c₃·t + c₂.
    std::array<double, 4> turns{0, 0, 0, until};
    const double a = 6 * c[4], b = 3 * c[3], inside = b * b - 4 * a * c[2];
    if (inside > 0) {
        const double q = -(b + std::copysign(std::sqrt(inside), b)) / 2;
        const double one = q / a, other = c[2] / q;  // infinite where a = 0
        turns[1] = std::clamp(std::min(one, other), 0.0, until);
        turns[2] = std::clamp(std::max(one, other), 0.0, until);
    }
    // The polynomial is monotone between these.
    std::array<double, 5> extremes{};
    std::size_t count = 1;
    for (std::size_t k = 0; k < 3; ++k)
        if ((df(turns[k]) < 0) != (df(turns[k + 1]) < 0))
            extremes[count++] = root_between(turns[k], turns[k + 1], df, ddf);
    extremes[count] = until;
    for (std::size_t k = 0; k < count; ++k) {
        const double low = extremes[k], high = extremes[k + 1];
        if (!(df((low + high) / 2) < 0)) continue;
        if (f(low) <= 0) return low;
        if (f(high) <= 0) return root_between(low, high, f, df);
    }
    return INFINITY;
}

}  // namespace flipside::custom
