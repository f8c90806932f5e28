#include "custom/geometry/narrow_phase.hpp"

#include <limits>
#include <numbers>

namespace flipside::custom {

namespace {

/// Closest point on a solid circle of radius `core` about `at`; a point has radius 0.
Touch touch_circle(Vec2 center, double radius, Vec2 at, double core, Vec2 fallback = {0, 1}) {
    const Vec2 away = center - at;
    const double distance = length(away);
    const Vec2 normal = distance > 0 ? away / distance : fallback;
    return {at + core * normal, normal, distance - core - radius, false};
}

/// Closest point where that is an end of an open curve.
Touch touch_end(Vec2 center, double radius, Vec2 end) {
    Touch found = touch_circle(center, radius, end, 0);
    found.past_end = true;
    return found;
}

/// Angle of a direction, anticlockwise from `from`, in [0, 2π).
double angle_from(double from, Vec2 direction) {
    constexpr double full = 2 * std::numbers::pi;
    double angle = std::fmod(angle_of(direction) - from, full);
    if (angle < 0) angle += full;
    return angle < full ? angle : 0;
}

Touch touch(Vec2 center, double radius, const primitive::Point& primitive) {
    return touch_circle(center, radius, primitive.at, 0);
}

Touch touch(Vec2 center, double radius, const primitive::Circle& primitive) {
    return touch_circle(center, radius, primitive.center, primitive.radius);
}

Touch touch(Vec2 center, double radius, const primitive::Segment& primitive) {
    const Vec2 along = primitive.b - primitive.a, from_a = center - primitive.a;
    const double position = dot(from_a, along) / length_squared(along);
    if (position < 0) return touch_end(center, radius, primitive.a);
    if (position > 1) return touch_end(center, radius, primitive.b);
    const Vec2 left = unit(perp(along));
    const double height = dot(from_a, left);
    const Vec2 normal = height < 0 ? -left : left;
    return {center - height * left, normal, std::abs(height) - radius, false};
}

Touch touch(Vec2 center, double radius, const primitive::Arc& primitive) {
    const Vec2 out = center - primitive.center;
    const double distance = length(out);
    // At the centre all points of the arc have the same distance; this takes its middle.
    const Vec2 direction = distance > 0 ? out / distance : from_angle((primitive.from + primitive.to) / 2);
    if (angle_from(primitive.from, direction) > primitive.to - primitive.from) {
        const Vec2 first = primitive.center + primitive.radius * from_angle(primitive.from);
        const Vec2 last = primitive.center + primitive.radius * from_angle(primitive.to);
        const bool nearer_first = length_squared(center - first) <= length_squared(center - last);
        return touch_end(center, radius, nearer_first ? first : last);
    }
    const bool inside = distance < primitive.radius;
    return {primitive.center + primitive.radius * direction, inside ? -direction : direction,
            std::abs(distance - primitive.radius) - radius, false};
}

// The edge with the greatest signed distance decides (separating axis): inside the polygon it is the
// nearest edge, outside the closest point is on it or is one of its two corners.
Touch touch(Vec2 center, double radius, const primitive::Polygon& primitive) {
    const auto& points = primitive.points;
    const auto corner = [&](std::size_t i) { return points[i < points.size() ? i : 0]; };
    std::size_t edge = 0;
    double height = -std::numeric_limits<double>::infinity();
    Vec2 normal;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 outward = unit(-perp(corner(i + 1) - points[i]));
        const double above = dot(center - points[i], outward);
        if (above > height) height = above, edge = i, normal = outward;
    }
    const Vec2 a = points[edge], b = corner(edge + 1);
    if (height > 0) {
        if (dot(center - a, b - a) < 0) return touch_circle(center, radius, a, 0);
        if (dot(center - b, a - b) < 0) return touch_circle(center, radius, b, 0);
    }
    return {center - height * normal, normal, height - radius, false};
}

// In the frame of the axis, mirrored so that the disc is on the left of it: the straight side runs from
// circle a to circle b with outward normal (sine, cosine); past its ends the circles are nearest.
// After Quilez 2018, "2D distance functions" (uneven capsule).
Touch touch(Vec2 center, double radius, const primitive::Taper& primitive) {
    const Vec2 axis = primitive.b - primitive.a;
    const double span = length(axis);
    const Vec2 forward = axis / span, left = perp(forward);
    const Vec2 from_a = center - primitive.a;
    const double x = dot(from_a, forward), height = dot(from_a, left);
    const double side = height < 0 ? -1 : 1, y = std::abs(height);
    const double sine = (primitive.radius_a - primitive.radius_b) / span;
    const double cosine = std::sqrt((1 - sine) * (1 + sine));
    const double along = cosine * x - sine * y;
    if (along < 0) return touch_circle(center, radius, primitive.a, primitive.radius_a, -forward);
    if (along > cosine * span) return touch_circle(center, radius, primitive.b, primitive.radius_b, forward);
    const double above = sine * x + cosine * y - primitive.radius_a;
    const Vec2 normal = sine * forward + (side * cosine) * left;
    return {center - above * normal, normal, above - radius, false};
}

}  // namespace

Touch touch(Vec2 center, double radius, const Primitive& primitive, const Pose& pose) {
    const Vec2 local = pose.undo(center);
    Touch found = std::visit([&](const auto& kind) { return touch(local, radius, kind); }, primitive.is);
    if (pose.angle != 0) {
        found.point = pose.apply(found.point);
        found.normal = rotated(found.normal, pose.angle);
    }
    return found;
}

Touch touch(Vec2 center_a, double radius_a, Vec2 center_b, double radius_b) {
    return touch_circle(center_a, radius_a, center_b, radius_b);
}

}  // namespace flipside::custom
