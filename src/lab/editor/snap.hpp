#pragma once
/// Where a point comes to lie that a hand puts about there: on the end of another part, so that walls join,
/// or on a grid, or in a direction of a multiple of 15 degrees from another point.

#include <optional>
#include <span>

#include "world/vec2.hpp"

namespace flipside::lab {

struct SnapRules {
    bool on = true;
    double pitch = 0.01;  ///< m, of the grid
    double reach = 0.01;  ///< m, of the ends of others
};

enum class SnappedTo { nothing, grid, end, angle };

struct Snapped {
    Vec2 at;
    SnappedTo to = SnappedTo::nothing;
};

inline constexpr double snap_degrees = 15;

/// An end within reach comes first. Else the nearer of the grid's point and of the point in such a direction
/// from `anchor`, a whole number of pitches away. Without snapping, as it is.
[[nodiscard]] Snapped snap(Vec2 point, std::span<const Vec2> ends, std::optional<Vec2> anchor,
                           const SnapRules& rules);
/// How far something moves that is moved about by so much: so that one of its ends comes to an end of others,
/// or its first end to the grid.
[[nodiscard]] Vec2 snap_move(Vec2 by, std::span<const Vec2> own, std::span<const Vec2> ends,
                             const SnapRules& rules);
/// The multiple of 15 degrees nearest to an angle, rad.
[[nodiscard]] double snap_angle(double angle);
/// The finest of 1, 2, 5, 10, ... mm with at most a hundred lines over `extent`, m.
[[nodiscard]] double usual_pitch(double extent);
/// Those that can be chosen, m.
[[nodiscard]] std::span<const double> pitches();

}  // namespace flipside::lab
