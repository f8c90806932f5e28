#pragma once
/// Narrow phase: where a disc and a shape are closest. Pure functions of plain values; what to do about
/// it is the response's business.

#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::custom {

/// How a disc lies to a surface.
struct Touch {
    Vec2 point;             ///< m, closest point of the surface
    Vec2 normal;            ///< unit, from the surface towards the disc
    double separation = 0;  ///< m between the two surfaces, negative when they overlap
    /// The closest point is an end of an open curve (segment, arc). Where that end can be hit, a point
    /// primitive stands for it, so such a touch is not the curve's own.
    bool past_end = false;
};

/// Of the disc (center, radius) with each kind of primitive in the pose of the scene file. Exact up to
/// rounding for every position, also with the disc's centre inside a solid primitive (the normal then points
/// to the nearest surface). Where the closest point is ambiguous, one is chosen by a fixed rule. Constant
/// cost, or linear in the corners of a polygon.
[[nodiscard]] Touch touch(Vec2 center, double radius, const primitive::Point& primitive);
[[nodiscard]] Touch touch(Vec2 center, double radius, const primitive::Segment& primitive);
[[nodiscard]] Touch touch(Vec2 center, double radius, const primitive::Arc& primitive);
[[nodiscard]] Touch touch(Vec2 center, double radius, const primitive::Circle& primitive);
[[nodiscard]] Touch touch(Vec2 center, double radius, const primitive::Polygon& primitive);
[[nodiscard]] Touch touch(Vec2 center, double radius, const primitive::Taper& primitive);

/// With a primitive of any kind, turned into a pose.
[[nodiscard]] Touch touch(Vec2 center, double radius, const Primitive& primitive, const Pose& pose = {});

/// Of disc a with disc b; point and normal as seen from b.
[[nodiscard]] Touch touch(Vec2 center_a, double radius_a, Vec2 center_b, double radius_b);

}  // namespace flipside::custom
