#pragma once
/// The path of a ball from one event to the next.
///
/// Flights, and balls that slide or roll on a static line, have a closed form: v' = a − c·v with constant a
/// and drag c gives
///     v(t) = v₀·e^(−ct) + a·E,    p(t) = p₀ + v₀·E + a·F,    E = (1 − e^(−ct))/c,    F = (t − E)/c,
/// without drag E = t and F = ½t². It is written with φ(x) = (x − 1 + e^(−x))/x², which is ½ at 0, so that it
/// is exact to rounding for any c ≥ 0. Balls in resting contact with curved or turning surfaces follow a
/// Taylor polynomial (resting_contact.hpp).

#include <array>

#include "reference/real.hpp"

namespace flipside::reference {

/// φ(x) = (x − 1 + e^(−x))/x², x ≥ 0.
template <class R>
R drag_phi(const R& x) {
    using math::expm1;
    if (x > 0.5) return (x + expm1(R(-x))) / (x * x);
    R term = R(0.5), sum = term;
    for (int k = 3; term > epsilon<R>() / 8 || -term > epsilon<R>() / 8; ++k) {
        term *= -x / k;
        sum += term;
    }
    return sum;
}

/// Highest power of a Taylor polynomial: about half the digits that are wanted, times ln 10 (Jorba and Zou
/// 2005, "A software package for the numerical integration of ODEs by means of high-order Taylor methods").
template <class R>
inline constexpr std::size_t taylor_order = std::numeric_limits<R>::digits * 7 / 20 + 2;
template <class T, class R>
using Series = std::array<T, taylor_order<R> + 1>;

template <class R>
struct Motion {
    V<R> position, velocity;
};
template <class R>
struct Spinning {
    R angle, spin;
};
/// Bounds on speed and acceleration over an interval.
template <class R>
struct Bounds {
    R speed, acceleration;
};

template <class R>
struct Path {
    R start{};                        ///< s
    V<R> position, velocity;          ///< at the start
    V<R> acceleration;                ///< constant part of it; of closed forms
    R drag{};                         ///< 1/s
    R angle{}, spin{};                ///< at the start
    R spin_rate{};                    ///< rad/s²; of closed forms
    V<R> roll;                        ///< for a ball that rolls on a static line: its spin is roll·velocity
    bool is_series = false;           ///< follows the series below instead of the closed form
    bool rests = false;               ///< the centre does not move; the ball may spin
    Series<V<R>, R> displacements{};  ///< of the position
    Series<R, R> spins{};             ///< of the spin
    Bounds<R> series_bounds{};        ///< as long as the series is used

    [[nodiscard]] Motion<R> at(const R& time) const {
        const R t = time - start;
        if (rests) return {position, {}};
        if (is_series) return series_at(t);
        if (!(drag > 0))
            return {position + t * (velocity + (t / 2) * acceleration), velocity + t * acceleration};
        const R x = drag * t, phi = drag_phi(x), e = 1 - x * phi;
        return {position + t * (e * velocity + (t * phi) * acceleration),
                (1 - x * e) * velocity + (t * e) * acceleration};
    }
    [[nodiscard]] Spinning<R> spinning_at(const R& time) const {
        const R t = time - start;
        if (is_series) {
            R turned{}, gained{};
            for (std::size_t k = taylor_order<R>; k >= 1; --k) {
                const auto power = static_cast<int>(k);
                gained = t * (gained + spins[k]);
                turned = t * (turned + spins[k] / (power + 1));
            }
            return {angle + t * (spin + turned), spin + gained};
        }
        if (roll.x != 0 || roll.y != 0) {
            const Motion<R> now = at(time);
            return {angle + dot(roll, now.position - position), dot(roll, now.velocity)};
        }
        return {angle + t * (spin + (t / 2) * spin_rate), spin + t * spin_rate};
    }
    /// Acceleration at the start.
    [[nodiscard]] V<R> begins_with() const {
        if (rests) return {};
        return is_series ? R(2) * displacements[2] : acceleration - drag * velocity;
    }
    [[nodiscard]] Bounds<R> bounds(const R& from, const R& until) const {
        if (rests) return {};
        if (is_series) return series_bounds;
        const R speed = length(at(from).velocity) + length(acceleration) * (until - from);
        return {speed, length(acceleration) + drag * speed};
    }

    /// Bound on the acceleration along a unit vector.
    [[nodiscard]] R acceleration_bound_along(const V<R>& n, const R& from, const R& until) const {
        if (rests) return R(0);
        if (is_series) return series_bounds.acceleration;
        R pulled = magnitude(dot(n, acceleration));
        if (!(drag > 0)) return pulled;
        return pulled + drag * (magnitude(dot(n, at(from).velocity)) + pulled * (until - from));
    }

  private:
    [[nodiscard]] Motion<R> series_at(const R& t) const {
        V<R> sum, slope;
        for (std::size_t k = taylor_order<R>; k >= 1; --k) {
            slope = t * slope + sum;
            sum = t * sum + displacements[k];
        }
        return {position + t * sum, t * slope + sum};
    }
};

}  // namespace flipside::reference
