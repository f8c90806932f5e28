#pragma once
/// The place of a primitive that is nearest to a point.

#include "world/surface.hpp"

namespace flipside::app {

/// The point itself where it lies inside a solid. Exact but for rounding.
[[nodiscard]] Vec2 nearest_of(const Primitive& primitive, Vec2 point);
/// Around a primitive, m.
[[nodiscard]] Box box_of(const Primitive& primitive);

}  // namespace flipside::app
