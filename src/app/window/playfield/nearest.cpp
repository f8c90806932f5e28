#include "app/window/playfield/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace flipside::app {

namespace {

Vec2 on_segment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 along = b - a;
    const double squared = dot(along, along);
    return squared == 0 ? a : a + std::clamp(dot(p - a, along) / squared, 0.0, 1.0) * along;
}

Vec2 nearer(Vec2 p, Vec2 a, Vec2 b) {
    return length(p - a) <= length(p - b) ? a : b;
}

struct Nearest {
    Vec2 p;

    Vec2 on_circle(Vec2 center, double radius) const { return center + radius * unit(p - center, {1, 0}); }
    Vec2 operator()(const primitive::Point& s) const { return s.at; }
    Vec2 operator()(const primitive::Segment& s) const { return on_segment(s.a, s.b, p); }
    Vec2 operator()(const primitive::Arc& s) const {
        constexpr double full = 2 * std::numbers::pi;
        const double angle = angle_of(p - s.center) - s.from;
        if (angle - full * std::floor(angle / full) <= s.to - s.from) return on_circle(s.center, s.radius);
        return nearer(p, s.center + s.radius * from_angle(s.from), s.center + s.radius * from_angle(s.to));
    }
    Vec2 operator()(const primitive::Circle& s) const {
        return length(p - s.center) <= s.radius ? p : on_circle(s.center, s.radius);
    }
    Vec2 operator()(const primitive::Polygon& s) const {
        bool inside = true;
        Vec2 best = s.points.front();
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const Vec2 a = s.points[i], b = s.points[(i + 1) % s.points.size()];
            inside = inside && cross(b - a, p - a) >= 0;
            best = nearer(p, best, on_segment(a, b, p));
        }
        return inside ? p : best;
    }
    /// Along the straight side the radius changes evenly: the foot leans by the angle of the side.
    Vec2 operator()(const primitive::Taper& s) const {
        const Vec2 along = s.b - s.a;
        const double span = length(along), lean = (s.radius_a - s.radius_b) / span;
        const Vec2 u = along / span;
        const double across = std::abs(cross(u, p - s.a));
        const double foot = dot(p - s.a, u) - across * lean / std::sqrt(1 - lean * lean);
        const double t = std::clamp(foot / span, 0.0, 1.0);
        return (*this)(primitive::Circle{s.a + t * along, s.radius_a + t * (s.radius_b - s.radius_a)});
    }
};

Box around(std::initializer_list<Vec2> points, double by) {
    Box box{*points.begin(), *points.begin()};
    for (const Vec2 p : points)
        box = {{std::min(box.min.x, p.x), std::min(box.min.y, p.y)},
               {std::max(box.max.x, p.x), std::max(box.max.y, p.y)}};
    return {box.min - Vec2{by, by}, box.max + Vec2{by, by}};
}

struct Around {
    Box operator()(const primitive::Point& s) const { return around({s.at}, 0); }
    Box operator()(const primitive::Segment& s) const { return around({s.a, s.b}, 0); }
    Box operator()(const primitive::Arc& s) const { return around({s.center}, s.radius); }
    Box operator()(const primitive::Circle& s) const { return around({s.center}, s.radius); }
    Box operator()(const primitive::Polygon& s) const {
        Box box = around({s.points.front()}, 0);
        for (const Vec2 p : s.points) box = around({box.min, box.max, p}, 0);
        return box;
    }
    Box operator()(const primitive::Taper& s) const {
        return around({s.a, s.b}, std::max(s.radius_a, s.radius_b));
    }
};

}  // namespace

Vec2 nearest_of(const Primitive& primitive, Vec2 point) {
    return std::visit(Nearest{point}, primitive.is);
}

Box box_of(const Primitive& primitive) {
    return std::visit(Around{}, primitive.is);
}

}  // namespace flipside::app
