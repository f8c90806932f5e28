#pragma once
/// Two convex polygons: separating axis with a manifold. Pure geometry.

#include <span>

#include "world/vec2.hpp"

namespace flipside::custom {

/// How two polygons lie to each other.
struct PolygonContact {
    Vec2 normal;            ///< unit, from a to b: the axis of least overlap
    double separation = 0;  ///< m along the normal; negative when they overlap, −depth then
    int count = 0;          ///< contact points: 0 when apart, else 1 or 2
    Vec2 points[2];         ///< m, corners of the other polygon clipped to the reference face's sides
    double separations[2] = {0, 0};  ///< m, of each point from the reference face
};

/// Corners anticlockwise, convex, at least three each. Separated polygons give the greatest separation
/// over the edges' axes, a lower bound of their distance. Cost: corners of a times corners of b.
/// Gottschalk, Lin, Manocha 1996, "OBBTree" (separating axis); Sutherland, Hodgman 1974 (clipping).
[[nodiscard]] PolygonContact polygon_contact(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace flipside::custom
