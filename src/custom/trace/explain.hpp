#pragma once
/// Explains a closest point in words and numbers: the closest feature of the shape and the formula. Used only
/// by traces.

#include "custom/geometry/narrow_phase.hpp"
#include "world/trace.hpp"

namespace flipside::custom {

/// Adds to the item `shape`, `feature` (the region that decided), `formula` and `filled` (the formula with
/// its numbers), and its construction, in metres in the world's frame:
/// - of a segment, its ends `a` and `b`, the `foot` of the perpendicular on its line, the
///   position of the foot `along` it (0 at a, 1 at b) and its `clamped` value;
/// - of an arc, the same along its angle, its `middle`, radius `core` and angles `from` and `to`;
/// - of a capsule or flipper, the same along its straight side, with the radii `core` and `other_core`;
/// - of a polygon, its corners as `outline` (x, y, x, y, ...), the same along the closest edge, and
///   the `heights` of the centre of the disc above each edge, of which the greatest decides.
void explain_touch(TraceItem& item, Vec2 center, double radius, const Primitive& primitive, const Pose& pose);
/// The same for two discs.
void explain_touch(TraceItem& item, Vec2 center_a, double radius_a, Vec2 center_b, double radius_b);

/// Adds to the stage a copy of `about` for each separating axis on which a disc and a polygon were tested, in
/// the order of the narrow phase: the normal of every edge, then the axis through a corner if that is the
/// closest point. It gets what the axis is `of` ("edge 2", "corner 0"), the outward unit vector `axis`, the
/// projections `shadow_of_part` and `shadow_of_ball` from the world's origin, their overlap `depth`, negative
/// for a gap, and whether it `decides`: it has the smallest overlap, or shows the gap. Lengths are in metres.
void explain_axes(TraceStage& stage, TraceItem about, Vec2 center, double radius,
                  const primitive::Polygon& polygon, const Pose& pose);

}  // namespace flipside::custom
