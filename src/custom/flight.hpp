#pragma once
/// Free flight in closed form: v' = a − c·v with constant a and drag c, so
///     v(t) = v₀·e^(−ct) + a·E(t),    p(t) = p₀ + v₀·E(t) + a·F(t),
///     E = (1 − e^(−ct))/c,           F = (t − E)/c.
/// Without drag E = t and F = ½t². Written with φ(x) = (x − 1 + e^(−x))/x² all of it stays accurate to
/// rounding for any c ≥ 0. Error: rounding only, whatever the length of the flight.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "world/ball.hpp"

namespace flipside::custom {

/// The first terms of φ(x) = Σ (−x)^k/(k + 2)!; the compiler knows how many, so that no loop is left.
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
/// φ(x) = (x − 1 + e^(−x))/x² for 0 ≤ x ≤ ½; ½ at 0. What is left out is below rounding.
inline double drag_phi(double x) {
    return x < 0.004 ? drag_series<6>(x) : drag_series<14>(x);
}

/// What a interval of time does to every flight with the same drag. Made once, it serves many balls.
struct TimeInterval {
    double time;
    double kept = 1;  ///< e^(−ct): the part of a velocity that is left
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
        const double phi = drag_phi(x), part = 1 - x * phi;
        kept = 1 - x * part;
        shrunk = t * part;
        fallen = t * t * phi;
    }
};

/// Inverse of E: the t at which E(t) = e; infinite where drag stops the motion before.
inline double drag_time(double c, double e) {
    if (c <= 0) return e;
    return c * e < 1 ? -math::log1p(-c * e) / c : INFINITY;
}

/// When v₀·e^(−ct) + a·E(t), with v₀ and a of opposite signs, is 0.
inline double drag_turn(double v, double a, double c) {
    return c > 0 ? math::log1p(-c * v / a) / c : -v / a;
}

/// Positions are given as displacements from the start, so that differences to a near reference point
/// keep their digits far from the origin.
struct Flight {
    Vec2 position;      ///< m, at t = 0
    Vec2 velocity;      ///< m/s, at t = 0
    Vec2 acceleration;  ///< m/s², constant
    double drag = 0;    ///< c ≥ 0, 1/s

    [[nodiscard]] Vec2 displacement(const TimeInterval& s) const {
        return s.shrunk * velocity + s.fallen * acceleration;
    }
    [[nodiscard]] Vec2 displacement(double t) const { return displacement(TimeInterval(drag, t)); }
    [[nodiscard]] Vec2 velocity_after(const TimeInterval& s) const {
        return s.kept * velocity + s.shrunk * acceleration;
    }
    [[nodiscard]] Vec2 velocity_at(double t) const { return velocity_after(TimeInterval(drag, t)); }
    /// Bounds on speed and on the size of dv/dt over [0, t].
    [[nodiscard]] double max_speed(double t) const { return length(velocity) + length(acceleration) * t; }
    [[nodiscard]] double max_acceleration(double t) const {
        return length(acceleration) + (drag > 0 ? drag * max_speed(t) : 0);
    }
    /// A box around the path over [0, t]: it strays from the chord by at most k·t²/8 (k: acceleration).
    [[nodiscard]] Box bounds(const TimeInterval& s) const;
    [[nodiscard]] Box bounds(double t) const { return bounds(TimeInterval(drag, t)); }
};

/// Where a ball gets that flies freely under `gravity`; the interval is one with the table's damping.
inline Vec2 end_of_flight(const Ball& ball, Vec2 gravity, const TimeInterval& s) {
    return ball.position + Flight{{}, ball.velocity, gravity}.displacement(s);
}
/// Moves it there.
inline void fly_freely(Ball& ball, Vec2 gravity, const TimeInterval& s) {
    ball.position = end_of_flight(ball, gravity, s);
    ball.velocity = Flight{{}, ball.velocity, gravity}.velocity_after(s);
    ball.angle += ball.spin * s.time;
}

inline Box Flight::bounds(const TimeInterval& s) const {
    const Vec2 end = displacement(s);
    const double sag = max_acceleration(s.time) * s.time * s.time / 8;
    return {position + Vec2{std::min(0.0, end.x) - sag, std::min(0.0, end.y) - sag},
            position + Vec2{std::max(0.0, end.x) + sag, std::max(0.0, end.y) + sag}};
}

}  // namespace flipside::custom
