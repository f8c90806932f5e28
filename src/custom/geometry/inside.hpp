#pragma once
/// Is a point in a shape: a question without a ball in it.

#include "world/shape.hpp"

namespace flipside::custom {

/// Of a shape as the scene file places it, borders included. What has no inside (points, segments, arcs,
/// polylines, gates) contains nothing; a compound contains what any of its shapes does. Cost: linear in
/// corners and members.
[[nodiscard]] bool inside(Vec2 point, const Shape& shape);

}  // namespace flipside::custom
