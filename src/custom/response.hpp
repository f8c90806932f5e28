#pragma once
/// Collision response: what a touch does to the balls. Knows no shapes and no broad phase.

#include "custom/geometry/narrow_phase.hpp"
#include "world/ball.hpp"
#include "world/scene.hpp"

namespace flipside::custom {

/// What a response needs to know of the world around the touch.
struct Surroundings {
    Vec2 gravity;           ///< m/s²
    double rest_speed = 0;  ///< m/s
    /// s: how long the balls flew freely before the touch was looked for. A touch within this time is
    /// answered as if it had been found at once.
    double flown = 0;
    /// s: how long gravity has driven them since touches were last looked for.
    double driven = 0;
};

/// What a response did.
struct Impact {
    bool happened = false;  ///< an impact faster than rest_speed; else a resting touch, or none
    Vec2 normal;            ///< from other to ball, at the moment of touch
    double speed = 0;       ///< m/s, approach at the moment of touch
    double impulse = 0;     ///< N·s along the normal
    double ago = 0;         ///< s since the moment of touch
};

/// A ball against a surface of infinite mass whose point of touch moves at `surface_velocity`.
/// An impact is answered at the moment of touch: the flight is followed back by its energy and angular
/// momentum, and the change of velocity acts from then on. A resting touch (approach below rest_speed
/// at the surface, so what gravity added since does not count) loses its normal speed and is pushed out.
[[nodiscard]] Impact respond(Ball& ball, const Touch& touch, Vec2 surface_velocity, const Mixed& material,
                             const Surroundings& around);

/// Two balls; momentum is conserved to rounding, and with e = 1 and µ = 0 so is energy. The normal points
/// from b to a. A ball with `held` stays as it is, as if its mass were infinite.
[[nodiscard]] Impact respond(Ball& a, Ball& b, bool held_b, const Mixed& material,
                             const Surroundings& around);

/// How long ago two balls that now part touched on their way through each other, when they flew straight
/// for `flown` seconds; infinite if they did not.
[[nodiscard]] double passed_through(const Ball& a, const Ball& b, double flown);

/// Moves overlapping things apart, by position only.
void push_out(Ball& ball, const Touch& touch);
/// The same for balls, shared by inverse mass; b stays where it is when held.
void push_out(Ball& a, Ball& b, bool held_b);

}  // namespace flipside::custom
