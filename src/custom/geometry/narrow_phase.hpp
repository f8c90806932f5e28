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
    /// piece stands for it, so such a touch is not the curve's own.
    bool past_end = false;
};

/// Of the disc (center, radius) with each kind of piece in the pose of the scene file. Exact up to rounding
/// for every position, also with the disc's centre inside a solid piece (the normal then points to the
/// nearest surface). Where the closest point is ambiguous, one is chosen by a fixed rule. Constant cost,
/// or linear in the corners of a polygon.
[[nodiscard]] Touch touch(Vec2 center, double radius, const piece::Point& piece);
[[nodiscard]] Touch touch(Vec2 center, double radius, const piece::Segment& piece);
[[nodiscard]] Touch touch(Vec2 center, double radius, const piece::Arc& piece);
[[nodiscard]] Touch touch(Vec2 center, double radius, const piece::Circle& piece);
[[nodiscard]] Touch touch(Vec2 center, double radius, const piece::Polygon& piece);
[[nodiscard]] Touch touch(Vec2 center, double radius, const piece::Taper& piece);

/// With a piece of any kind, turned into a pose.
[[nodiscard]] Touch touch(Vec2 center, double radius, const Piece& piece, const Pose& pose = {});

/// Of disc a with disc b; point and normal as seen from b.
[[nodiscard]] Touch touch(Vec2 center_a, double radius_a, Vec2 center_b, double radius_b);

}  // namespace flipside::custom
