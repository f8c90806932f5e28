#pragma once
/// The path of a ball from one event to the next: a flight in closed form, or, for a ball that swings
/// on a curved or turning surface (resting_contact.hpp), the Taylor polynomial of its position.

#include <array>

#include "custom/flight.hpp"

namespace flipside::custom {

/// Highest power of a Taylor polynomial.
inline constexpr int taylor_order = 22;

struct Path {
    double start = 0;  ///< s, in the time of the step
    Flight flight;     ///< its position and velocity are those at the start, whatever the path
    bool swings = false;
    std::array<Vec2, taylor_order + 1> taylor;   ///< of the displacement; used when it swings
    double top_speed = 0, top_acceleration = 0;  ///< bounds over the whole polynomial; used when it swings

    [[nodiscard]] Vec2 position(double time) const {
        const double t = time - start;
        return flight.position + (swings ? horner(t) : flight.displacement(t));
    }
    [[nodiscard]] Vec2 velocity(double time) const {
        const double t = time - start;
        return swings ? slope(t) : flight.velocity_at(t);
    }
    [[nodiscard]] Vec2 acceleration(double time) const {
        const double t = time - start;
        return swings ? bend(t) : flight.acceleration - flight.drag * flight.velocity_at(t);
    }
    /// Position and velocity at once.
    struct Motion {
        Vec2 position, velocity;
    };
    [[nodiscard]] Motion at(double time) const {
        const double t = time - start;
        if (swings) return {flight.position + horner(t), slope(t)};
        const TimeInterval interval(flight.drag, t);
        return {flight.position + flight.displacement(interval), flight.velocity_after(interval)};
    }
    /// Bounds on speed and acceleration from the start to `time`.
    [[nodiscard]] double max_speed(double time) const {
        return swings ? top_speed : flight.max_speed(time - start);
    }
    [[nodiscard]] double max_acceleration(double time) const {
        return swings ? top_acceleration : flight.max_acceleration(time - start);
    }

  private:
    [[nodiscard]] Vec2 horner(double t) const {
        Vec2 sum;
        for (int k = taylor_order; k >= 1; --k) sum = t * (sum + taylor[static_cast<std::size_t>(k)]);
        return sum;
    }
    [[nodiscard]] Vec2 slope(double t) const {
        Vec2 sum;
        for (int k = taylor_order; k >= 1; --k) sum = t * sum + k * taylor[static_cast<std::size_t>(k)];
        return sum;
    }
    [[nodiscard]] Vec2 bend(double t) const {
        Vec2 sum;
        for (int k = taylor_order; k >= 2; --k)
            sum = t * sum + k * (k - 1) * taylor[static_cast<std::size_t>(k)];
        return sum;
    }
};

}  // namespace flipside::custom
