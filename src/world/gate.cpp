#include "world/gate.hpp"

#include <algorithm>
#include <cmath>

namespace flipside {

namespace {

/// Radii: a centre this close to the line is on it: paths of a few dozen radii, computed in double, end
/// within this of where they would in exact numbers.
constexpr double on_line = 1e-9;
/// And so many times what double can tell apart at its place.
constexpr double place_rounding = 256 * 0x1p-53;
/// A velocity along the normal below this part of the speed is none.
constexpr double along_line = 1e-9;

}  // namespace

bool begins_deep(const shape::Gate& gate, Vec2 center, double radius) {
    const Vec2 along = gate.b - gate.a;
    const double share = std::clamp(dot(center - gate.a, along) / length_squared(along), 0.0, 1.0);
    return length(center - (gate.a + share * along)) < deep_in_gate * radius;
}

bool lets_through(const shape::Gate& gate, Vec2 center, Vec2 velocity, double radius) {
    const Vec2 across = perp(unit(gate.b - gate.a));
    const Vec2 normal = dot(across, gate.normal) > 0 ? across : -across;
    const double before = dot(center - gate.a, normal);
    const double band = on_line * radius + place_rounding * (std::abs(center.x) + std::abs(center.y));
    if (std::abs(before) > band) return before < 0;
    return dot(velocity, normal) > along_line * length(velocity);
}

}  // namespace flipside
