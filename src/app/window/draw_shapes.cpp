#include "app/window/draw_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace flipside::app {

namespace {

using std::numbers::pi;

/// The convex hull of two circles, in pixels: round ends as polygons, fine enough to look round.
std::vector<Vec2> taper(Vec2 a, double radius_a, Vec2 b, double radius_b) {
    const double along = angle_of(b - a);
    const double half = std::acos(std::clamp((radius_a - radius_b) / length(b - a), -1.0, 1.0));
    const auto round = [](std::vector<Vec2>& out, Vec2 center, double radius, double from, double to) {
        const int n = std::clamp(static_cast<int>(std::sqrt(radius) * 4), 6, 200);
        for (int i = 0; i <= n; ++i) out.push_back(center + radius * from_angle(from + (to - from) * i / n));
    };
    std::vector<Vec2> outline;
    round(outline, b, radius_b, along - half, along + half);
    round(outline, a, radius_a, along + half, along + 2 * pi - half);
    return outline;
}

struct Painter {
    Canvas& canvas;
    const Camera& camera;
    const Pose& pose;
    const ShapeStyle& style;

    [[nodiscard]] Vec2 at(Vec2 p) const { return camera.to_pixels(pose.apply(p)); }
    [[nodiscard]] std::vector<Vec2> at(const std::vector<Vec2>& points) const {
        std::vector<Vec2> pixels;
        pixels.reserve(points.size());
        for (const Vec2 p : points) pixels.push_back(at(p));
        return pixels;
    }
    void solid(const std::vector<Vec2>& outline) const {
        canvas.fill(outline, style.fill);
        canvas.stroke(outline, true, style.width, style.line);
    }

    void operator()(const shape::Point& s) const {
        canvas.disc(at(s.at), std::max(1.2 * style.width, 2.0), style.line);
    }
    void operator()(const shape::Segment& s) const { canvas.line(at(s.a), at(s.b), style.width, style.line); }
    void operator()(const shape::Arc& s) const {
        canvas.arc(at(s.center), camera.scale * s.radius, s.from + pose.angle, s.to + pose.angle, style.width,
                   style.line);
    }
    void operator()(const shape::Circle& s) const {
        const double radius = camera.scale * s.radius;
        if (style.glow > 0)
            canvas.disc(at(s.center), 1.35 * radius, with_alpha(style.line, 0.25 * style.glow));
        canvas.disc(at(s.center), radius, style.fill);
        canvas.ring(at(s.center), radius, style.width, style.line);
        if (radius > 4 * style.width)
            canvas.ring(at(s.center), 0.58 * radius, 0.6 * style.width, with_alpha(style.line, 0.6));
    }
    void operator()(const shape::Polygon& s) const { solid(at(s.points)); }
    void operator()(const shape::Capsule& s) const {
        const double radius = camera.scale * s.radius;
        solid(taper(at(s.a), radius, at(s.b), radius));
    }
    void operator()(const shape::Flipper& s) const {
        const Vec2 tip = s.pivot + s.length * from_angle(s.rest);
        solid(taper(at(s.pivot), camera.scale * s.base_radius, at(tip), camera.scale * s.tip_radius));
        canvas.disc(at(s.pivot), 0.35 * camera.scale * s.base_radius, style.line);
    }
    void operator()(const shape::Polyline& s) const {
        canvas.stroke(at(s.points), s.closed, style.width, style.line);
    }
    void operator()(const shape::Gate& s) const {
        const Vec2 a = at(s.a), b = at(s.b), middle = 0.5 * (a + b);
        const Vec2 way = unit({s.normal.x, -s.normal.y});
        const double reach = std::clamp(0.35 * length(b - a), 6.0, canvas.scaled(16));
        canvas.line(a, b, 0.5 * style.width, style.line);
        canvas.arrow(middle - reach * way, middle + reach * way, 0.75 * style.width, style.line);
    }
    void operator()(const shape::Compound& s) const {
        for (const Shape& shape : s.of) std::visit(*this, shape.is);
    }
};

}  // namespace

void draw_shape(Canvas& canvas, const Camera& camera, const Shape& shape, const Pose& pose,
                const ShapeStyle& style) {
    std::visit(Painter{canvas, camera, pose, style}, shape.is);
}

}  // namespace flipside::app
