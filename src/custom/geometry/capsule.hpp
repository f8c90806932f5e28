#pragma once
/// A capsule around each piece of the table: one test for every kind, without a root, a quotient or a
/// branch. Most candidates of the broad phase do not touch, and this says so first.

#include "world/surface.hpp"

namespace flipside::custom {

/// All points within `radius` of a straight core. Half a line of the cache: of what is near a ball, most is
/// read only to be told that it is not near enough.
struct alignas(32) Capsule {
    Vec2 from;                       ///< m, an end of the core
    float along_x = 0, along_y = 0;  ///< m, from there to the other end; 0 for a disc
    float per_square = 0;            ///< 1/m², 1/|along|²; 0 for a disc
    float radius = 0;                ///< m
};

/// Around a piece in its own pose, with room for rounding (1e-12 of its size and place, 1e-6 of its core's
/// length, since the core is kept in single precision). Tight but for that around points,
/// segments, circles and capsules; around arcs and polygons the smallest disc, around tapers a capsule of
/// the larger radius.
[[nodiscard]] Capsule capsule_around(const Piece& piece);

/// False only where the disc and what is inside the capsule do not overlap.
[[nodiscard]] inline bool overlap(const Capsule& capsule, Vec2 center, double radius) {
    const Vec2 from = center - capsule.from;
    const Vec2 along{capsule.along_x, capsule.along_y};
    const double at = dot(from, along) * capsule.per_square;
    const double low = at > 0 ? at : 0, on_core = low < 1 ? low : 1;
    const double reach = capsule.radius + radius;
    return length_squared(from - on_core * along) < reach * reach;
}

}  // namespace flipside::custom
