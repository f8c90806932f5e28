#pragma once
/// Between the scene's metres in double and Box2D's length units in float. Seconds, kilograms and radians
/// are the same in both.

#include <box2d/b2_math.h>

#include "world/vec2.hpp"

namespace flipside::box2d {

/// A frame of Box2D coordinates: where its origin lies in the scene and how many units make a metre.
/// Floats are finest near 0, so the world's origin is put at the centre of the scene's bounds.
struct Units {
    Vec2 origin;       ///< m
    double scale = 1;  ///< units per metre

    [[nodiscard]] b2Vec2 vector(Vec2 v) const {
        return {static_cast<float>(scale * v.x), static_cast<float>(scale * v.y)};
    }
    [[nodiscard]] b2Vec2 point(Vec2 p) const { return vector(p - origin); }
    [[nodiscard]] float distance(double d) const { return static_cast<float>(scale * d); }

    [[nodiscard]] Vec2 vector(b2Vec2 v) const { return {double{v.x} / scale, double{v.y} / scale}; }
    [[nodiscard]] Vec2 point(b2Vec2 p) const { return origin + vector(p); }
    [[nodiscard]] double distance(float d) const { return double{d} / scale; }
};

}  // namespace flipside::box2d
