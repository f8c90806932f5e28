#include "custom/geometry/inside.hpp"

#include <algorithm>
#include <cmath>

#include "custom/geometry/narrow_phase.hpp"

namespace flipside::custom {

namespace {

/// A point is a disc without radius: in a solid primitive where it is not apart from it.
struct Inside {
    Vec2 point;

    template <class Solid>
    [[nodiscard]] bool in(const Solid& solid) const {
        return touch(point, 0, solid).separation <= 0;
    }

    bool operator()(const shape::Circle& s) const { return in(primitive::Circle{s.center, s.radius}); }
    bool operator()(const shape::Polygon& s) const { return in(primitive::Polygon{s.points}); }
    bool operator()(const shape::Capsule& s) const {
        return in(primitive::Taper{s.a, s.b, s.radius, s.radius});
    }
    bool operator()(const shape::Flipper& s) const {
        const Vec2 tip = s.pivot + s.length * from_angle(s.rest);
        return in(primitive::Taper{s.pivot, tip, s.base_radius, s.tip_radius});
    }
    bool operator()(const shape::Compound& s) const {
        return std::ranges::any_of(s.of, [&](const Shape& member) { return inside(point, member); });
    }
    bool operator()(const shape::Point&) const { return false; }
    bool operator()(const shape::Segment&) const { return false; }
    bool operator()(const shape::Arc&) const { return false; }
    bool operator()(const shape::Polyline&) const { return false; }
    bool operator()(const shape::Gate&) const { return false; }
};

/// Half of a rectangle's extent along a unit vector, m.

}  // namespace

bool inside(Vec2 point, const Shape& shape) {
    return std::visit(Inside{point}, shape.is);
}

}  // namespace flipside::custom
