#pragma once
/// The smallest enclosing circle and rectangle of points. These bounds turn with a part, while its AABB must
/// be computed again for every pose.

#include <array>
#include <span>
#include <vector>

#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::custom {

struct Disc {
    Vec2 center;
    double radius = 0;  ///< m
};

/// An oriented rectangle.
struct Rectangle {
    Vec2 center;
    Vec2 along;  ///< unit, the direction of a side
    Vec2 half;   ///< half extents along that side and across it, m

    /// Anticlockwise.
    [[nodiscard]] std::array<Vec2, 4> corners() const;
};

/// Smallest circle around at least one point, to rounding. Cost: O(n) expected.
[[nodiscard]] Disc enclosing_disc(std::span<const Vec2> points);

/// Corners of the convex hull of at least one point, anticlockwise, without those on a straight side.
/// Cost: O(n log n).
[[nodiscard]] std::vector<Vec2> convex_hull(std::span<const Vec2> points);

/// Rectangle of the least area around at least one point. Cost: O(n log n).
[[nodiscard]] Rectangle enclosing_rectangle(std::span<const Vec2> points);

/// Appends points whose convex hull encloses a primitive: its corners, and for circles and arcs those of a
/// polygon around them, at most 0.13 % of the radius outside.
void append_outline(const Primitive& primitive, const Pose& pose, std::vector<Vec2>& points);

}  // namespace flipside::custom
