#pragma once
/// Axis-aligned bounding boxes (AABB) of discs and primitives.

#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside {

/// AABB of a disc.
[[nodiscard]] constexpr Box bounds_of(Vec2 center, double radius) {
    return {{center.x - radius, center.y - radius}, {center.x + radius, center.y + radius}};
}
/// AABB of a primitive in a pose; tight up to rounding.
[[nodiscard]] Box bounds_of(const Primitive& primitive, const Pose& pose = {});

/// Whether two closed boxes overlap; a common border counts.
[[nodiscard]] constexpr bool overlap(const Box& a, const Box& b) {
    return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) & (b.min.y <= a.max.y);
}
/// Smallest box that contains both.
[[nodiscard]] constexpr Box united(const Box& a, const Box& b) {
    return {{a.min.x < b.min.x ? a.min.x : b.min.x, a.min.y < b.min.y ? a.min.y : b.min.y},
            {a.max.x > b.max.x ? a.max.x : b.max.x, a.max.y > b.max.y ? a.max.y : b.max.y}};
}
/// The box enlarged by `margin` on every side.
[[nodiscard]] constexpr Box grown(const Box& box, double margin) {
    return {{box.min.x - margin, box.min.y - margin}, {box.max.x + margin, box.max.y + margin}};
}

/// Squared distance of p from the segment between a and b, m².
[[nodiscard]] inline double distance_squared(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double ahead = dot(p - a, along), l = length_squared(along);
    return length_squared(p - (ahead <= 0 ? a : ahead >= l ? b : a + ahead / l * along));
}

}  // namespace flipside
