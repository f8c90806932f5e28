#pragma once
/// Features: the lines, arcs and circles of which every primitive consists for the continuous solver; points,
/// corners and caps are circles. The second derivative of the distance from a feature is bounded along any
/// smooth path. A disc of radius r touches a feature when the distance of its centre is r.
///
/// Solid shapes are represented by their outlines: a disc outside can only enter through the outline.

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::custom {

/// How far a curve extends past its end, so that no ball slips through a joint. The extension is 0 where a
/// circle covers the end. At a smooth joint or a tangent point it covers the gap and the kink of the joint
/// and the rounding of positions. A resting contact extends by one more margin, so that it does not touch the
/// same curve again right after it has ended. The extension must not be longer, since the ball turns on a
/// curve.
struct EndExtension {
    bool joined = false;
    double gap = 0;       ///< m
    double kink = 0;      ///< rad
    double rounding = 0;  ///< m

    [[nodiscard]] double length(double radius) const {
        return joined ? gap + kink * radius + margin(radius) : 0;
    }
    [[nodiscard]] double resting_length(double radius) const {
        return joined ? length(radius) + margin(radius) : 0;
    }

  private:
    [[nodiscard]] double margin(double radius) const { return rounding + 64 * 0x1p-53 * radius; }
};

/// Two-sided straight face.
struct Line {
    Vec2 start, along;  ///< unit
    double length = 0;
    EndExtension before, past;
};

/// Two-sided arc, anticlockwise between two unit directions.
struct Arc {
    Vec2 center;
    double radius = 0;
    Vec2 from, to;
    Vec2 middle;             ///< unit, half way between them
    double half_cosine = 0;  ///< of the angle from there to either
    EndExtension before, past;
    bool wide = false;  ///< spans more than half a turn
    bool full = false;  ///< has no ends
};

/// The outside of a circle; radius 0 is a point.
struct Circle {
    Vec2 center;
    double radius = 0;
};

using FeatureIndex = std::uint32_t;

struct Feature {
    std::variant<Line, Arc, Circle> is;
    std::uint32_t primitive = 0;  ///< index into the primitives given
    PartIndex part = 0;
    // Copied from the part, for speed.
    std::uint32_t layer = 1, collides_with = ~0U;
    bool sensor = false;
    bool gate = false;
};

/// The feature of an arc, without extensions.
[[nodiscard]] Arc arc_of(const primitive::Arc& arc);

/// Features in the order of the primitives. Cost: linear, but n log n in the number of ends.
[[nodiscard]] std::vector<Feature> features_of(std::span<const Primitive> primitives, const Scene& scene);

/// Result of a closest-point query, in the pose of the scene file.
struct Closest {
    double distance = 0;  ///< m, of the point from the curve without ends, ≥ 0
    Vec2 normal;          ///< unit, from the curve to the point: the gradient of the distance
    bool facing = true;   ///< whether the closest point lies between the ends of the curve
};
[[nodiscard]] Closest closest_point(const Feature& feature, Vec2 point, double radius);

/// Cheap conservative test: true only if a disc whose centre stays within `sag` of the chord from a to b
/// cannot touch the feature (in the pose of the scene file).
[[nodiscard]] bool clear_of(const Feature& feature, Vec2 a, Vec2 b, double radius, double sag);

/// Whether the circle continues the face smoothly at one of its ends, so that a ball that slides off the face
/// touches the circle without an approach speed. `normal` is that of the face towards the ball; both features
/// are in the same pose.
[[nodiscard]] bool continues_in(const Feature& face, Vec2 normal, const Feature& circle);

/// Distance from `point` on the feature to its end in `direction` (unit), m, for a ball of this radius. For a
/// circle it is almost 0, so that the faces that it joins take precedence.
[[nodiscard]] double distance_to_end(const Feature& feature, Vec2 point, Vec2 direction, double radius);

/// The feature in the given pose.
[[nodiscard]] Feature posed(const Feature& feature, const Pose& pose);

/// Bounds of all positions that a feature of this primitive can have.
[[nodiscard]] Box range_of(const Feature& feature, const Primitive& primitive, const Table& table);

}  // namespace flipside::custom
