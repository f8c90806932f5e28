#pragma once
/// Limits of every world, whatever its engine. Scene files may not ask for more; a world that gets there by
/// itself refuses its step (refusal.hpp, step_guard.hpp).

#include <span>
#include <string>
#include <string_view>

#include "world/ball.hpp"
#include "world/events.hpp"

namespace flipside {

/// m/s: greatest speed of a ball's centre, and of its rim as the ball spins. Only energy that is gained
/// without end leads there, as by a restitution above 1 in a closed box. Squares of such speeds times masses
/// up to 1e36 kg are far from overflow, so up to here every number of an event is finite.
inline constexpr double top_speed = 1e9;
/// m: greatest coordinate of a ball. One that was lost and is kept flies on; there the rounding of a place
/// is 1e-4 m. State files take no more.
inline constexpr double farthest = 1e12;
/// s: greatest time of a world; the rounding of such a time is 1e-4 s. State files take no more.
inline constexpr double last_time = 1e12;

/// False also where a number is none.
[[nodiscard]] inline bool within_top_speed(const Ball& ball) {
    return length_squared(ball.velocity) <= top_speed * top_speed &&
           std::abs(ball.spin) * ball.radius <= top_speed;
}
[[nodiscard]] inline bool within_reach(const Ball& ball) {
    return std::abs(ball.position.x) <= farthest && std::abs(ball.position.y) <= farthest;
}

/// Throws Refusal for a ball that an impact with `met` at `time` has made faster than top_speed.
[[noreturn]] void refuse_speed(std::string_view engine, const Ball& ball, Other met, double time,
                               const Scene& scene);
/// Throws Refusal: the time at which `ball` touches or leaves `met`, from `time` on, was not found.
[[noreturn]] void refuse_search(std::string_view engine, BallNumber ball, Other met, double time,
                                const Scene& scene);
/// The same where `met` is neither a ball nor a part, as the bounds.
[[noreturn]] void refuse_search(std::string_view engine, BallNumber ball, const std::string& met,
                                double time);
/// Throws Refusal where a number of the event is infinite or none: an engine in single precision gets there
/// with balls of extreme radius or mass.
void require_finite(std::string_view engine, const Event& event, const Scene& scene);
/// Throws Refusal where a ball, or the time, is beyond the limits.
void require_limits(std::string_view engine, std::span<const Ball> balls, double time);

}  // namespace flipside
