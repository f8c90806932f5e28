#pragma once
/// How the narrow phase comes to a closest point, in words and numbers: which feature of the shape is nearest
/// and by which formula. For traces; the engine itself never asks.

#include "custom/geometry/narrow_phase.hpp"
#include "world/trace.hpp"

namespace flipside::custom {

/// Adds to the item `shape`, `feature` (the region that decided), `formula` and `filled` (the formula with
/// its numbers), and what it was constructed from, in metres in the world's frame:
/// - of a segment, its ends `a` and `b`, the `foot` of the perpendicular on its line, the place of that foot
///   `along` it (0 at a, 1 at b) and where it was `clamped` to;
/// - of an arc, the same along its angle, its `middle`, radius `core` and angles `from` and `to`;
/// - of a capsule or flipper, the same along its straight side, with the radii `core` and `other_core`;
/// - of a polygon, its corners as `outline` (x, y, x, y, ...), the same along the edge that is nearest, and
///   the `heights` of the disc's centre over each edge, of which the greatest decides.
void explain_touch(TraceItem& item, Vec2 center, double radius, const Primitive& primitive, const Pose& pose);
/// The same for two discs.
void explain_touch(TraceItem& item, Vec2 center_a, double radius_a, Vec2 center_b, double radius_b);

/// An axis on which a disc and a polygon were looked at.
struct TriedAxis {
    std::string of;        ///< "edge 2", "corner 0"
    Vec2 axis;             ///< unit, outward
    double polygon[2]{};   ///< m, its shadow, from the world's origin
    double disc[2]{};      ///< m
    bool decides = false;  ///< it has the smallest overlap, or shows the gap

    /// m, how far the disc reaches behind the polygon's end; below 0 it is the gap.
    [[nodiscard]] double overlap() const { return polygon[1] - disc[0]; }
};

/// In the order in which the narrow phase tries them: across every edge, then through a corner, if the
/// closest point is one.
[[nodiscard]] std::vector<TriedAxis> axes_tried(Vec2 center, double radius, const primitive::Polygon& polygon,
                                                const Pose& pose);

}  // namespace flipside::custom
