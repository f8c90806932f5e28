#pragma once
/// Collision response: the velocities of balls after a contact. Independent of shapes and broad phase.

#include "custom/geometry/narrow_phase.hpp"
#include "world/ball.hpp"
#include "world/scene.hpp"

namespace flipside::custom {

/// Parameters of the world for a response. Gravity matters only where contacts are found late: it has
/// accelerated balls that already overlap a part, and balls since the last search for contacts.
struct Surroundings {
    Vec2 gravity{};         ///< m/s²
    double rest_speed = 0;  ///< m/s
    /// s: for how long gravity has accelerated the balls since the last search for contacts.
    double gravity_time = 0;
};

/// Result of a response.
struct Impact {
    bool happened = false;  ///< an impact faster than rest_speed; else a resting contact, or none
    Vec2 normal;            ///< from other to ball
    double speed = 0;       ///< m/s, approach at the surface
    double impulse = 0;     ///< N·s along the normal
};

/// Response of a ball and a surface of infinite mass whose point of contact moves at `surface_velocity`. If
/// the ball is already below the surface, its approach speed at the surface follows from its energy, without
/// the speed that gravity added below. A resting contact (approach up to rest_speed) loses its normal speed.
[[nodiscard]] Impact respond(Ball& ball, const Touch& touch, Vec2 surface_velocity, const Mixed& material,
                             const Surroundings& around);

/// Response of two balls. Momentum is conserved to rounding; with e = 1 and µ = 0 energy is too. The normal
/// points from b to a. A ball of infinite mass does not change.
[[nodiscard]] Impact respond(Ball& a, Ball& b, const Mixed& material, const Surroundings& around);

/// Position correction: moves an overlapping ball out of a part.
void push_out(Ball& ball, const Touch& touch);
/// The same for two overlapping balls, weighted by inverse mass; the normal points from b to a.
void push_out(Ball& a, Ball& b, const Touch& touch);

}  // namespace flipside::custom
