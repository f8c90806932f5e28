#pragma once
/// The path of a ball from one event to the next: a flight in closed form, or, for a ball that swings
/// on a curved or turning surface (resting_contact.hpp), the Taylor polynomial of its position.

#include <array>
#include <vector>

#include "custom/flight.hpp"

namespace flipside::custom {

/// Highest power of a Taylor polynomial.
inline constexpr int taylor_order = 22;

/// Motion of a ball that swings, in powers of the time since its start.
struct Swing {
    std::array<Vec2, taylor_order + 1> displacement{};  ///< m
    std::array<double, taylor_order + 1> spin{};        ///< what the spin has changed by, rad/s
    double top_speed = 0, top_acceleration = 0;         ///< bounds over the whole polynomial

    [[nodiscard]] Vec2 position(double t) const {
        Vec2 sum;
        for (std::size_t k = taylor_order; k >= 1; --k) sum = t * (sum + displacement[k]);
        return sum;
    }
    [[nodiscard]] Vec2 velocity(double t) const {
        Vec2 sum;
        for (std::size_t k = taylor_order; k >= 1; --k)
            sum = t * sum + static_cast<double>(k) * displacement[k];
        return sum;
    }
    [[nodiscard]] Vec2 acceleration(double t) const {
        Vec2 sum;
        for (std::size_t k = taylor_order; k >= 2; --k)
            sum = t * sum + static_cast<double>(k * (k - 1)) * displacement[k];
        return sum;
    }
    [[nodiscard]] double spin_change(double t) const {
        double sum = 0;
        for (std::size_t k = taylor_order; k >= 1; --k) sum = t * (sum + spin[k]);
        return sum;
    }
};

struct Path {
    double start = 0;  ///< s, in the time of the step
    Flight flight;     ///< its position and velocity are those at the start, whatever the path
    /// One if the ball swings. Few do, and it is large: so it lies elsewhere, in room that is kept.
    std::vector<Swing> swing;

    [[nodiscard]] bool swings() const { return !swing.empty(); }
    [[nodiscard]] Vec2 position(double time) const {
        const double t = time - start;
        return flight.position + (swings() ? swing[0].position(t) : flight.displacement(t));
    }
    [[nodiscard]] Vec2 velocity(double time) const {
        const double t = time - start;
        return swings() ? swing[0].velocity(t) : flight.velocity_at(t);
    }
    [[nodiscard]] Vec2 acceleration(double time) const {
        const double t = time - start;
        return swings() ? swing[0].acceleration(t)
                        : flight.acceleration - flight.drag * flight.velocity_at(t);
    }
    /// Position and velocity at once.
    struct Motion {
        Vec2 position, velocity;
    };
    [[nodiscard]] Motion at(double time) const {
        const double t = time - start;
        if (swings()) return {flight.position + swing[0].position(t), swing[0].velocity(t)};
        const TimeInterval interval(flight.drag, t);
        return {flight.position + flight.displacement(interval), flight.velocity_after(interval)};
    }
    /// Bounds on speed and acceleration from the start to `time`.
    [[nodiscard]] double max_speed(double time) const {
        return swings() ? swing[0].top_speed : flight.max_speed(time - start);
    }
    [[nodiscard]] double max_acceleration(double time) const {
        return swings() ? swing[0].top_acceleration : flight.max_acceleration(time - start);
    }
};

}  // namespace flipside::custom
