#pragma once
/// The rule of gates, the same for every engine.
///
/// The gate rule applies when the centre of a ball first comes within its radius of the gate's segment. At
/// that instant it is decided, once, whether the gate lets the ball through:
///
/// - an open gate lets every ball through;
/// - a closed one lets a ball through whose centre is behind it: on the side from which its normal points
///   away;
/// - a centre on the line of the segment, to a declared tolerance, is behind it if the ball moves along the
///   normal, else before it.
///
/// A ball that begins within a radius of a gate (in a scene, in a state that says nothing of it, by a launch)
/// meets it there and then; one that begins deep in it is on its way through, and is let through. A closed
/// gate is solid to a ball that it does not let through, with both ends of its segment, and stays so until
/// the ball has left: until its surface is gate_clearance away. A gate is open while a ball that it let
/// through has not left. One that opens is open to all, also to those that lay against it.

#include "world/shape.hpp"

namespace flipside {

/// So far from a gate's segment, in radii beyond its own radius, a ball has left it. Lower hops on a gate do
/// not leave it.
inline constexpr double gate_clearance = 1e-9;

/// A ball whose centre begins nearer than this to the segment, in radii, begins deep in the gate.
inline constexpr double deep_in_gate = 0.5;

/// Whether a ball that begins with its centre at `center`, in the pose of the scene file, begins deep in it.
[[nodiscard]] bool begins_deep(const shape::Gate& gate, Vec2 center, double radius);

/// Whether a closed gate lets a ball through whose centre is at `center` when it reaches the gate. Both in
/// the pose of the scene file; the velocity is that of the ball's centre as seen from the gate.
[[nodiscard]] bool lets_through(const shape::Gate& gate, Vec2 center, Vec2 velocity, double radius);

}  // namespace flipside
