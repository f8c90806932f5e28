#pragma once
/// Plane vectors in double precision. x points right, y points up, angles are radians anticlockwise.

#include <cmath>

#include "world/math.hpp"

namespace flipside {

struct Vec2 {
    double x = 0;
    double y = 0;

    friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
    constexpr Vec2& operator+=(Vec2 b) { return x += b.x, y += b.y, *this; }
    constexpr Vec2& operator-=(Vec2 b) { return x -= b.x, y -= b.y, *this; }
    constexpr Vec2& operator*=(double s) { return x *= s, y *= s, *this; }
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) {
    return {a.x + b.x, a.y + b.y};
}
constexpr Vec2 operator-(Vec2 a, Vec2 b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Vec2 operator-(Vec2 a) {
    return {-a.x, -a.y};
}
constexpr Vec2 operator*(double s, Vec2 a) {
    return {s * a.x, s * a.y};
}
constexpr Vec2 operator*(Vec2 a, double s) {
    return {s * a.x, s * a.y};
}
constexpr Vec2 operator/(Vec2 a, double s) {
    return {a.x / s, a.y / s};
}

constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// z of the 3D cross product: positive when b lies anticlockwise of a.
constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// ω × r: the velocity of a point at r from the axis of a body turning at `rate`.
constexpr Vec2 cross(double rate, Vec2 r) {
    return {-rate * r.y, rate * r.x};
}
/// a turned a quarter anticlockwise.
constexpr Vec2 perp(Vec2 a) {
    return {-a.y, a.x};
}
constexpr double length_squared(Vec2 a) {
    return dot(a, a);
}
inline double length(Vec2 a) {
    return std::sqrt(dot(a, a));
}
/// Unit vector along a; `fallback` where a is too short to have a direction.
inline Vec2 unit(Vec2 a, Vec2 fallback = {0, 1}) {
    const double l = length(a);
    return l > 0 ? a / l : fallback;
}
inline Vec2 from_angle(double angle) {
    const auto [s, c] = math::sincos(angle);
    return {c, s};
}
inline double angle_of(Vec2 a) {
    return math::atan2(a.y, a.x);
}
inline Vec2 rotated(Vec2 a, double angle) {
    const auto [s, c] = math::sincos(angle);
    return {c * a.x - s * a.y, s * a.x + c * a.y};
}
inline bool is_finite(Vec2 a) {
    return std::isfinite(a.x) && std::isfinite(a.y);
}

/// Axis-aligned rectangle. Closed: a point on the border is inside.
struct Box {
    Vec2 min;
    Vec2 max;

    friend constexpr bool operator==(const Box&, const Box&) = default;
    [[nodiscard]] constexpr bool contains(Vec2 p) const {
        return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
    }
};

}  // namespace flipside
