#pragma once
/// Collision response: what a touch does to the balls. Knows no shapes and no broad phase.

#include "custom/geometry/narrow_phase.hpp"
#include "world/ball.hpp"
#include "world/scene.hpp"

namespace flipside::custom {

/// What a response needs to know of the world around the contact.
struct Surroundings {
    Vec2 gravity;           ///< m/s²
    double rest_speed = 0;  ///< m/s
    /// s: how long gravity has driven the balls since contacts were last looked for.
    double driven = 0;
};

/// What a response did.
struct Impact {
    bool happened = false;  ///< an impact faster than rest_speed; else a resting contact, or none
    Vec2 normal;            ///< from other to ball
    double speed = 0;       ///< m/s, approach at the surface
    double impulse = 0;     ///< N·s along the normal
};

/// A ball against a surface of infinite mass whose point of contact moves at `surface_velocity`. Where the
/// ball is already below the surface, its approach there follows from energy: what gravity has added on the
/// way in does not count. A resting contact (approach up to rest_speed) loses its normal speed.
[[nodiscard]] Impact respond(Ball& ball, const Touch& touch, Vec2 surface_velocity, const Mixed& material,
                             const Surroundings& around);

/// Two balls; momentum is conserved to rounding, and with e = 1 and µ = 0 so is energy. The normal points
/// from b to a. A ball of infinite mass stays as it is.
[[nodiscard]] Impact respond(Ball& a, Ball& b, const Mixed& material, const Surroundings& around);

/// Moves overlapping things apart, by position only.
void push_out(Ball& ball, const Touch& touch);
/// The same for balls, shared by inverse mass.
void push_out(Ball& a, Ball& b);

}  // namespace flipside::custom
