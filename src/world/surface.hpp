#pragma once
/// The surface of a scene, split into primitives with one simple distance function each. All engines use
/// these, so they agree on edges, ends and joints.
///
/// Faces and ends are separate: a segment or arc primitive is the open curve between its ends, and where
/// an end can be hit there is a point primitive for it. Where two curves meet with a common tangent (a smooth
/// joint) there is none, so no ball can catch on it; where they meet in a corner there is one.

#include <variant>
#include <vector>

#include "world/scene.hpp"

namespace flipside {

namespace primitive {

struct Point {
    Vec2 at;
};
/// Two-sided.
struct Segment {
    Vec2 a, b;
};
/// Two-sided, anticlockwise from `from` to `to` (rad).
struct Arc {
    Vec2 center;
    double radius, from, to;
};
/// Solid.
struct Circle {
    Vec2 center;
    double radius;
};
/// Solid, convex, anticlockwise.
struct Polygon {
    std::vector<Vec2> points;
};
/// Solid: the convex hull of two circles, neither inside the other. Capsules (equal radii) and flippers.
struct Taper {
    Vec2 a, b;
    double radius_a, radius_b;
};

}  // namespace primitive

struct Primitive {
    std::variant<primitive::Point, primitive::Segment, primitive::Arc, primitive::Circle, primitive::Polygon,
                 primitive::Taper>
        is;
    PartIndex part = 0;
};

/// Ends closer than this form one joint, m.
inline constexpr double joint_distance = 1e-6;
/// Tangents that differ by less than this at a joint make it smooth, rad.
inline constexpr double joint_angle = 1e-3;

/// Every primitive of every part, in the pose of the scene file, by part. Joints are sought within a part,
/// and between still solid parts that share layers and cannot vanish (no sensors, targets or gates).
/// Gates are a segment primitive and a point primitive at each end, joined to nothing. Cost: O(n log n) in
/// the number of primitives.
[[nodiscard]] std::vector<Primitive> surface_of(const Scene& scene);

/// The gate of a part, or null.
[[nodiscard]] const shape::Gate* gate_of(const Part& part);

}  // namespace flipside
