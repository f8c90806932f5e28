#pragma once
/// Is a point in a shape, and do boxes in any direction overlap: questions without a ball's flight in them.

#include "custom/geometry/enclosing.hpp"
#include "world/shape.hpp"

namespace flipside::custom {

/// Of a shape as the scene file places it, borders included. What has no inside (points, segments, arcs,
/// polylines, gates) contains nothing; a compound contains what any of its shapes does. Cost: linear in
/// corners and members.
[[nodiscard]] bool inside(Vec2 point, const Shape& shape);

/// Of a rectangle in any direction, borders included.
[[nodiscard]] bool inside(Vec2 point, const Rectangle& rectangle);

/// Rectangles in any direction, borders included, by the separating axis test on their four directions
/// (Gottschalk, Lin, Manocha 1996, "OBBTree"). Constant cost.
[[nodiscard]] bool overlap(const Rectangle& a, const Rectangle& b);

}  // namespace flipside::custom
