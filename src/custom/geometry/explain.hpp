#pragma once
/// How the narrow phase comes to a closest point, in words and numbers: which feature of the shape is nearest
/// and by which formula. For traces; the engine itself never asks.

#include "custom/geometry/narrow_phase.hpp"
#include "world/trace.hpp"

namespace flipside::custom {

/// Adds to the item `shape`, `feature`, `formula` and `filled` (the formula with its numbers); of a polygon
/// also `heights`, m: the disc's centre over each edge, of which the greatest decides (separating axis).
void explain_touch(TraceItem& item, Vec2 center, double radius, const Piece& piece, const Pose& pose);
/// The same for two discs.
void explain_touch(TraceItem& item, Vec2 center_a, double radius_a, Vec2 center_b, double radius_b);

}  // namespace flipside::custom
