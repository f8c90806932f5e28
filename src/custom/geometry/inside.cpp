#include "custom/geometry/inside.hpp"

#include <algorithm>
#include <cmath>

#include "custom/geometry/narrow_phase.hpp"

namespace flipside::custom {

namespace {

/// A point is a disc without radius: in a solid piece where it is not apart from it.
struct Inside {
    Vec2 point;

    template <class Solid>
    [[nodiscard]] bool in(const Solid& solid) const {
        return touch(point, 0, solid).separation <= 0;
    }

    bool operator()(const shape::Circle& s) const { return in(piece::Circle{s.center, s.radius}); }
    bool operator()(const shape::Polygon& s) const { return in(piece::Polygon{s.points}); }
    bool operator()(const shape::Capsule& s) const { return in(piece::Taper{s.a, s.b, s.radius, s.radius}); }
    bool operator()(const shape::Flipper& s) const {
        const Vec2 tip = s.pivot + s.length * from_angle(s.rest);
        return in(piece::Taper{s.pivot, tip, s.base_radius, s.tip_radius});
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
double reach(const Rectangle& rectangle, Vec2 axis) {
    return rectangle.half.x * std::abs(dot(rectangle.along, axis)) +
           rectangle.half.y * std::abs(dot(perp(rectangle.along), axis));
}

}  // namespace

bool inside(Vec2 point, const Shape& shape) {
    return std::visit(Inside{point}, shape.is);
}

bool inside(Vec2 point, const Rectangle& rectangle) {
    const Vec2 from_center = point - rectangle.center;
    return std::abs(dot(from_center, rectangle.along)) <= rectangle.half.x &&
           std::abs(dot(from_center, perp(rectangle.along))) <= rectangle.half.y;
}

bool overlap(const Rectangle& a, const Rectangle& b) {
    const Vec2 axes[] = {a.along, perp(a.along), b.along, perp(b.along)};
    return std::ranges::all_of(axes, [&](Vec2 axis) {
        return std::abs(dot(b.center - a.center, axis)) <= reach(a, axis) + reach(b, axis);
    });
}

}  // namespace flipside::custom
