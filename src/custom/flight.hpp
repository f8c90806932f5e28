#pragma once
/// Free flight in closed form: v' = a − c·v with constant a and drag c, so
///     v(t) = v₀·e^(−ct) + a·E(t),    p(t) = p₀ + v₀·E(t) + a·F(t),
///     E = (1 − e^(−ct))/c,           F = (t − E)/c.
/// Without drag E = t and F = ½t². Written with φ(x) = (x − 1 + e^(−x))/x² all of it stays accurate to
/// rounding for any c ≥ 0. Error: rounding only, whatever the length of the flight.

#include <iterator>

#include "world/ball.hpp"

namespace flipside::custom {

/// The first terms of φ(x) = Σ (−x)^k/(k + 2)!, which differ from it by less than rounding: 6 for x < 0.004,
/// 14 for x ≤ ½. Their number is a constant, so that the compiler unrolls the loop.
template <std::size_t terms>
double drag_series(double x) {
    constexpr double one_over[] = {
        1 / 2.0,         1 / 6.0,          1 / 24.0,          1 / 120.0,          1 / 720.0,
        1 / 5040.0,      1 / 40320.0,      1 / 362880.0,      1 / 3628800.0,      1 / 39916800.0,
        1 / 479001600.0, 1 / 6227020800.0, 1 / 87178291200.0, 1 / 1307674368000.0};
    double sum = 0;
    static_assert(terms <= std::size(one_over));
    for (std::size_t k = terms; k-- > 0;) sum = one_over[k] - x * sum;
    return sum;
}

/// The factors of a flight over a time interval. They depend only on the drag, so one object serves many
/// balls.
struct TimeInterval {
    double time;
    double kept = 1;  ///< e^(−ct): the part of a velocity that remains
    double shrunk;    ///< E, s
    double fallen;    ///< F, s²

    TimeInterval(double drag, double t) : time(t), shrunk(t), fallen(0.5 * t * t) {
        if (drag <= 0) return;
        const double x = drag * t;
        if (x > 0.5) {
            const double lost = -math::expm1(-x);
            kept = 1 - lost;
            shrunk = lost / drag;
            fallen = (t - shrunk) / drag;
            return;
        }
        const double phi = x < 0.004 ? drag_series<6>(x) : drag_series<14>(x), part = 1 - x * phi;
        kept = 1 - x * part;
        shrunk = t * part;
        fallen = t * t * phi;
    }
    /// p(t) − p₀, which keeps its digits far from the origin, and v(t), for v₀ = v.
    [[nodiscard]] Vec2 displacement(Vec2 v, Vec2 a) const { return shrunk * v + fallen * a; }
    [[nodiscard]] Vec2 velocity(Vec2 v, Vec2 a) const { return kept * v + shrunk * a; }
};

/// Moves a ball in free flight under `gravity`; the interval is one with the damping of the table.
inline void fly_freely(Ball& ball, Vec2 gravity, const TimeInterval& s) {
    ball.position += s.displacement(ball.velocity, gravity);
    ball.velocity = s.velocity(ball.velocity, gravity);
    ball.angle += ball.spin * s.time;
}

}  // namespace flipside::custom
