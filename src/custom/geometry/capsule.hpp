#pragma once
/// A capsule around each piece of the table: one test for every kind, without a root, a quotient or a
/// branch. Most candidates of the broad phase do not touch, and this says so first.

#include "world/surface.hpp"

namespace flipside::custom {

/// All points within `radius` of a straight core.
struct Capsule {
    Vec2 from;              ///< m, an end of the core
    Vec2 along;             ///< m, from there to the other end; 0 for a disc
    double per_square = 0;  ///< 1/m², 1/|along|²; 0 for a disc
    double radius = 0;      ///< m
};

/// Around a piece in its own pose, with room for rounding (1e-12 of its size and place). Tight around points,
/// segments, circles and capsules; around arcs and polygons the smallest disc, around tapers a capsule of
/// the larger radius.
[[nodiscard]] Capsule capsule_around(const Piece& piece);

/// False only where the disc and what is inside the capsule do not overlap.
[[nodiscard]] inline bool overlap(const Capsule& capsule, Vec2 center, double radius) {
    const Vec2 from = center - capsule.from;
    const double at = dot(from, capsule.along) * capsule.per_square;
    const double low = at > 0 ? at : 0, on_core = low < 1 ? low : 1;
    const double reach = capsule.radius + radius;
    return length_squared(from - on_core * capsule.along) < reach * reach;
}

}  // namespace flipside::custom
