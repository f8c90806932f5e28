#pragma once
/// The path of a ball from one event to the next: a flight in closed form, or a Taylor polynomial for a ball
/// in resting contact with a curved or turning surface (resting_contact.hpp).

#include <array>
#include <vector>

#include "custom/flight.hpp"

namespace flipside::custom {

/// A flight (flight.hpp).
struct Flight {
    Vec2 position;      ///< m, at t = 0
    Vec2 velocity;      ///< m/s, at t = 0
    Vec2 acceleration;  ///< m/s², constant
    double drag = 0;    ///< c ≥ 0, 1/s

    struct Motion {
        Vec2 position, velocity;  ///< m, m/s
    };
    [[nodiscard]] Motion at(double t) const {
        const TimeInterval s(drag, t);
        return {position + s.displacement(velocity, acceleration), s.velocity(velocity, acceleration)};
    }
    [[nodiscard]] Vec2 velocity_at(double t) const {
        return TimeInterval(drag, t).velocity(velocity, acceleration);
    }
    /// Bounds on speed and on the size of dv/dt over [0, t].
    [[nodiscard]] double max_speed(double t) const { return length(velocity) + length(acceleration) * t; }
    [[nodiscard]] double max_acceleration(double t) const {
        return length(acceleration) + (drag > 0 ? drag * max_speed(t) : 0);
    }
};

/// Highest power of a Taylor polynomial.
inline constexpr int taylor_order = 22;

/// Coefficients of a polynomial in time.
template <class T>
struct Series {
    std::array<T, taylor_order + 1> terms{};

    [[nodiscard]] T& operator[](int k) { return terms[static_cast<std::size_t>(k)]; }
    [[nodiscard]] const T& operator[](int k) const { return terms[static_cast<std::size_t>(k)]; }

    /// The value at t less that at 0, and both derivatives.
    [[nodiscard]] T change(double t) const {
        T sum{};
        for (int k = taylor_order; k >= 1; --k) sum = t * (sum + (*this)[k]);
        return sum;
    }
    /// Integral of change() from 0 to t.
    [[nodiscard]] T integral(double t) const {
        T sum{};
        for (int k = taylor_order; k >= 1; --k) sum = t * (sum + (*this)[k] / (k + 1));
        return t * sum;
    }
    [[nodiscard]] T slope(double t) const {
        T sum{};
        for (int k = taylor_order; k >= 1; --k) sum = t * sum + k * (*this)[k];
        return sum;
    }
    [[nodiscard]] T bend(double t) const {
        T sum{};
        for (int k = taylor_order; k >= 2; --k) sum = t * sum + k * (k - 1) * (*this)[k];
        return sum;
    }
};

/// Motion of a ball in powers of the time since the start of its path.
struct TaylorPath {
    Series<Vec2> displacement;                   ///< m
    Series<double> spin;                         ///< change of the spin, rad/s
    double top_speed = 0, top_acceleration = 0;  ///< m/s and m/s², bounds over the whole polynomial
};

struct Path {
    double start = 0;  ///< s, in the time of the window
    Flight flight;     ///< has the position and velocity at the start for both kinds of path
    /// One element if the path is a Taylor polynomial, else none. It is large and rare, so it is not stored
    /// inline.
    std::vector<TaylorPath> taylor;

    [[nodiscard]] bool is_taylor() const { return !taylor.empty(); }
    [[nodiscard]] Flight::Motion at(double time) const {
        const double t = time - start;
        if (!is_taylor()) return flight.at(t);
        return {flight.position + taylor[0].displacement.change(t), taylor[0].displacement.slope(t)};
    }
    [[nodiscard]] Vec2 position(double time) const { return at(time).position; }
    [[nodiscard]] Vec2 velocity(double time) const { return at(time).velocity; }
    [[nodiscard]] Vec2 acceleration(double time) const {
        const double t = time - start;
        return is_taylor() ? taylor[0].displacement.bend(t)
                           : flight.acceleration - flight.drag * flight.velocity_at(t);
    }
    /// Bounds on speed and acceleration from the start to `time`.
    [[nodiscard]] double max_speed(double time) const {
        return is_taylor() ? taylor[0].top_speed : flight.max_speed(time - start);
    }
    [[nodiscard]] double max_acceleration(double time) const {
        return is_taylor() ? taylor[0].top_acceleration : flight.max_acceleration(time - start);
    }
};

}  // namespace flipside::custom
