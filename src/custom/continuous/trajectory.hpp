#pragma once
/// A ball's path between two events, in closed form: v' = a − c·v with constant a and drag c, so
///     v(t) = v₀·e^(−ct) + a·E(t),    p(t) = p₀ + v₀·E(t) + a·F(t),
///     E = (1 − e^(−ct))/c,           F = (t − E)/c.
/// Without drag E = t and F = ½t². Written with φ(x) = (x − 1 + e^(−x))/x² all of it stays accurate to
/// rounding for any c ≥ 0. Error: rounding only, whatever the length of the flight.
///
/// Positions are given as displacements from the start, so that differences to a near reference point
/// keep their digits far from the origin.

#include <algorithm>
#include <cmath>

#include "world/vec2.hpp"

namespace flipside::custom {

struct Trajectory {
    Vec2 position;      ///< m, at t = 0
    Vec2 velocity;      ///< m/s, at t = 0
    Vec2 acceleration;  ///< m/s², constant
    double drag = 0;    ///< c ≥ 0, 1/s

    [[nodiscard]] Vec2 displacement(double t) const;
    [[nodiscard]] Vec2 velocity_at(double t) const;
    /// Bounds on speed and on the size of dv/dt over [0, t].
    [[nodiscard]] double max_speed(double t) const { return length(velocity) + length(acceleration) * t; }
    [[nodiscard]] double max_acceleration(double t) const {
        return length(acceleration) + (drag > 0 ? drag * max_speed(t) : 0);
    }
    /// The smallest box around the path over [0, t]: its ends and, per axis, its apex.
    [[nodiscard]] Box bounds(double t) const;
};

/// φ(x) = (x − 1 + e^(−x))/x², x ≥ 0; ½ at 0.
inline double drag_phi(double x) {
    if (x > 0.5) return (x + std::expm1(-x)) / (x * x);
    double term = 0.5, sum = 0.5;
    for (int k = 3; std::abs(term) > 1e-18; ++k) sum += term *= -x / k;
    return sum;
}

/// E(t), the time that drag leaves of t. Its inverse is drag_stretch.
inline double drag_shrink(double c, double t) {
    return c > 0 ? -std::expm1(-c * t) / c : t;
}
/// The t at which E(t) = e; infinite where drag stops the motion before.
inline double drag_stretch(double c, double e) {
    if (c <= 0) return e;
    return c * e < 1 ? -std::log1p(-c * e) / c : INFINITY;
}

inline Vec2 Trajectory::displacement(double t) const {
    if (drag <= 0) return t * (velocity + (0.5 * t) * acceleration);
    const double x = drag * t, phi = drag_phi(x);
    return t * ((1 - x * phi) * velocity + (t * phi) * acceleration);
}

inline Vec2 Trajectory::velocity_at(double t) const {
    if (drag <= 0) return velocity + t * acceleration;
    const double x = drag * t, e = 1 - x * drag_phi(x);
    return (1 - x * e) * velocity + (t * e) * acceleration;
}

inline Box Trajectory::bounds(double t) const {
    const Vec2 end = displacement(t);
    Box box{{std::min(0.0, end.x), std::min(0.0, end.y)}, {std::max(0.0, end.x), std::max(0.0, end.y)}};
    const auto apex = [&](double v, double a) -> double {
        if (v * a >= 0) return INFINITY;
        return drag > 0 ? std::log1p(-drag * v / a) / drag : -v / a;
    };
    if (const double s = apex(velocity.x, acceleration.x); s < t) {
        const double x = displacement(s).x;
        box.min.x = std::min(box.min.x, x);
        box.max.x = std::max(box.max.x, x);
    }
    if (const double s = apex(velocity.y, acceleration.y); s < t) {
        const double y = displacement(s).y;
        box.min.y = std::min(box.min.y, y);
        box.max.y = std::max(box.max.y, y);
    }
    return {position + box.min, position + box.max};
}

}  // namespace flipside::custom
