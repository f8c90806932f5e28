#include "lab/editor/snap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipside::lab {

namespace {

constexpr double all_pitches[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10};
constexpr double finest = 1e-5;  ///< m, of what a hand draws without a grid

/// A short decimal number, as it would be written: 0.3 rather than 3 · 0.1.
double to_multiple(double value, double of) {
    const double per_unit = 1 / of, count = std::round(value / of);
    const double multiple = per_unit == std::round(per_unit) ? count / per_unit : count * of;
    return multiple + 0.0;  // no negative zero
}

Vec2 to_grid(Vec2 p, double pitch) {
    return {to_multiple(p.x, pitch), to_multiple(p.y, pitch)};
}

std::optional<Vec2> nearest_end(Vec2 point, std::span<const Vec2> ends, double reach) {
    std::optional<Vec2> nearest;
    for (const Vec2 end : ends)
        if (length(end - point) <= reach) {
            reach = length(end - point);
            nearest = end;
        }
    return nearest;
}

}  // namespace

double snap_angle(double angle) {
    constexpr double unit = snap_degrees * std::numbers::pi / 180;
    return unit * std::round(angle / unit);
}

Snapped snap(Vec2 point, std::span<const Vec2> ends, std::optional<Vec2> anchor, const SnapRules& rules) {
    if (!rules.on) return {to_grid(point, finest), SnappedTo::nothing};
    if (const auto end = nearest_end(point, ends, rules.reach)) return {*end, SnappedTo::end};
    const Vec2 on_grid = to_grid(point, rules.pitch);
    if (!anchor) return {on_grid, SnappedTo::grid};
    const Vec2 way = point - *anchor;
    const double far = to_multiple(length(way), rules.pitch);
    const Vec2 along = *anchor + far * from_angle(snap_angle(angle_of(way)));
    if (far == 0 || length(along - point) >= length(on_grid - point)) return {on_grid, SnappedTo::grid};
    return {along, SnappedTo::angle};
}

Vec2 snap_move(Vec2 by, std::span<const Vec2> own, std::span<const Vec2> ends, const SnapRules& rules) {
    if (!rules.on || own.empty()) return to_grid(by, finest);
    std::optional<Vec2> joined;
    double reach = rules.reach;
    for (const Vec2 end : own)
        if (const auto other = nearest_end(end + by, ends, reach)) {
            reach = length(*other - end - by);
            joined = *other - end;
        }
    return joined ? *joined : to_grid(own.front() + by, rules.pitch) - own.front();
}

double usual_pitch(double extent) {
    constexpr double lines = 100;
    const auto* found = std::ranges::lower_bound(all_pitches, extent / lines);
    return found == std::end(all_pitches) ? *(found - 1) : *found;
}

std::span<const double> pitches() {
    return all_pitches;
}

}  // namespace flipside::lab
