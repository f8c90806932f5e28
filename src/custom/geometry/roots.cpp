#include "custom/geometry/roots.hpp"

#include "custom/flight.hpp"

namespace flipside::custom {

double first_crossing(double gap, double rate, double bend) {
    if (gap <= 0 && rate < 0) return 0;
    // b² − 2ac with the rounding of one operation (Kahan).
    const double w = 2 * gap * bend;
    const double discriminant = std::fma(rate, rate, -w) + std::fma(-2 * gap, bend, w);
    if (rate < 0) return discriminant < 0 ? never_touch : 2 * gap / (-rate + std::sqrt(discriminant));
    if (bend >= 0) return never_touch;
    return (rate + std::sqrt(std::max(0.0, discriminant))) / -bend;
}

double first_crossing(double gap, double rate, double bend, double drag) {
    if (drag <= 0) return first_crossing(gap, rate, bend);
    if (gap <= 0 && rate < 0) return 0;
    if (rate >= 0 && bend >= 0) return never_touch;
    const auto gap_at = [&](const TimeInterval& s) { return gap + s.shrunk * rate + s.fallen * bend; };
    // The second derivative keeps its sign and decays; the slope changes its sign at most once, at `turn`.
    const double curve = bend - drag * rate;
    const double turn = rate * bend < 0 ? drag_turn(rate, bend, drag) : never_touch;
    double t = 0;
    if (rate >= 0) {
        if (rate > 0) t = turn;
        const double top = gap_at(TimeInterval(drag, t));
        if (top <= 0) return t;
        t += std::sqrt(2 * top / -bend);
    } else {
        const double deepest = turn < never_touch ? gap_at(TimeInterval(drag, turn)) : gap + rate / drag;
        if (bend >= 0 && deepest > 0) return never_touch;
        if (const double without = first_crossing(gap, rate, curve); without < turn) t = without;
    }
    // Newton steps. After the first one they stay on the side from which they cannot skip the root.
    constexpr int most_steps = 100;  // grazes take about 50
    for (int step = 0; step < most_steps; ++step) {
        const TimeInterval s(drag, t);
        const double slope = s.kept * rate + s.shrunk * bend;
        if (slope >= 0) return t;
        const double next = std::max(0.0, t - gap_at(s) / slope);
        if (step > 0 && (curve < 0 ? next >= t : next <= t)) return t;
        if (!std::isfinite(next)) return never_touch;
        t = next;
    }
    return t;  // every step came nearer: the rest is rounding
}

double safe_time(double value, double slope, double k) {
    if (k <= 0) return slope < 0 ? value / -slope : never_touch;
    const double root = std::sqrt(slope * slope + 2 * k * value);
    return slope < 0 ? 2 * value / (root - slope) : (slope + root) / k;
}

namespace {

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
    const auto f = [&](double t) { return (((c[4] * t + c[3]) * t + c[2]) * t + c[1]) * t + c[0]; };
    const auto df = [&](double t) { return ((4 * c[4] * t + 3 * c[3]) * t + 2 * c[2]) * t + c[1]; };
    const auto ddf = [&](double t) { return (12 * c[4] * t + 6 * c[3]) * t + 2 * c[2]; };

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
    return never_touch;
}

}  // namespace flipside::custom
