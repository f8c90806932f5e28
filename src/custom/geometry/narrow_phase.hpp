#pragma once
/// Narrow phase: the closest point of a disc and a shape. Pure functions of plain values.

#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::custom {

/// Result of a narrow-phase test of a disc and a surface.
struct Touch {
    Vec2 point;             ///< m, closest point of the surface
    Vec2 normal;            ///< unit, from the surface towards the disc
    double separation = 0;  ///< m between the two surfaces, negative when they overlap
    /// Whether the closest point is an end of an open curve (segment, arc). Ends that can be hit have a point
    /// primitive of their own, so such a contact does not belong to the curve.
    bool past_end = false;
};

/// Closest point of the disc (center, radius) and a primitive in a pose. Exact up to rounding for every
/// position, also with the disc's centre inside a solid primitive (the normal then points to the nearest
/// surface). If there are several closest points, a fixed rule chooses one. Constant cost, or linear in the
/// corners of a polygon.
[[nodiscard]] Touch touch(Vec2 center, double radius, const Primitive& primitive, const Pose& pose = {});

/// The same for two discs; point and normal belong to disc b.
[[nodiscard]] Touch touch(Vec2 center_a, double radius_a, Vec2 center_b, double radius_b);

}  // namespace flipside::custom
