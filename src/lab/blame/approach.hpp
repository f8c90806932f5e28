#pragma once
/// What a step's start tells of an impact in it: how fast ball and other come together, whether they rub, and
/// whether a normal is right.

#include "world/events.hpp"
#include "world/state.hpp"

namespace flipside::lab {

/// m/s, of the ball of that number relative to what it meets, at the time of the impact. Of a moving part
/// only the normal speed, which is in the event, tells that it moves.
[[nodiscard]] Vec2 approach_velocity(const Event& impact, BallNumber number, const State& before,
                                     const Scene& scene);
/// Whether the friction between the two is above 0.
[[nodiscard]] bool rubs(const Event& impact, const State& before, const Scene& scene);
/// The angle, rad, between the normal of an impact and that of the surface where the event has the ball. Two
/// balls have no other normal than the line between their centres.
[[nodiscard]] double misread_normal(const Event& impact, const State& after, const Scene& scene);

}  // namespace flipside::lab
