#pragma once
/// The surface of the table as the continuous solver sees it: every primitive taken apart into lines, arcs
/// and circles (points, corners and caps too), each with a distance whose second derivative is bounded
/// along any smooth path. A disc of radius r touches a feature where its centre's distance is r.
///
/// Solid shapes are their outlines here: a centre outside can only come in through the outline.

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::custom {

/// How far a curve reaches past its end. Nothing past an end where a circle stands; at a smooth joint or
/// a tangent point past the joint's own gap and kink, and the rounding of positions there, so that nothing
/// slips through. What it holds it keeps a little further, so that it does not touch again what it let go of
/// there. (No further than that: on a curve the ball turns meanwhile.)
struct Reach {
    bool joined = false;
    double gap = 0;       ///< m
    double kink = 0;      ///< rad
    double rounding = 0;  ///< m

    [[nodiscard]] double of(double radius) const { return joined ? gap + kink * radius + margin(radius) : 0; }
    [[nodiscard]] double holds(double radius) const { return joined ? of(radius) + margin(radius) : 0; }

  private:
    [[nodiscard]] double margin(double radius) const { return rounding + 64 * 0x1p-53 * radius; }
};

/// Two-sided straight face.
struct Line {
    Vec2 start, along;  ///< unit
    double length = 0;
    Reach before, past;
};

/// Two-sided arc, anticlockwise between two unit directions.
struct Arc {
    Vec2 center;
    double radius = 0;
    Vec2 from, to;
    Vec2 middle;             ///< unit, half way between them
    double half_cosine = 0;  ///< of the angle from there to either
    Reach before, past;
    bool wide = false;  ///< spans more than half a turn
    bool full = false;  ///< has no ends
};

/// The outside of a circle; radius 0 is a point.
struct Circle {
    Vec2 center;
    double radius = 0;
};

struct Feature {
    std::variant<Line, Arc, Circle> is;
    std::uint32_t primitive = 0;  ///< index into the primitives given
    PartIndex part = 0;
    // Of the part, kept at hand.
    std::uint32_t layer = 1, collides_with = ~0U;
    bool sensor = false;
    bool gate = false;
};

/// Of an arc, reaching past neither end.
[[nodiscard]] Arc arc_of(const primitive::Arc& arc);

/// In the order of the primitives, so by part. Cost: linear (joints: n log n).
[[nodiscard]] std::vector<Feature> features_of(std::span<const Primitive> primitives, const Scene& scene);

/// A point as seen from a feature, both in the pose of the scene file.
struct Closest {
    double distance = 0;  ///< m, of the point from the (endless) curve, ≥ 0
    Vec2 normal;          ///< unit, from the curve to the point: the gradient of the distance
    bool facing = true;   ///< the nearest point of the curve lies between its ends
};
[[nodiscard]] Closest closest_point(const Feature& feature, Vec2 point, double radius);

/// Whether a disc whose centre stays within `sag` of the chord from a to b surely does not touch the feature
/// (in the pose of the scene file). Cheap, and true only where that is easy to see.
[[nodiscard]] bool clear_of(const Feature& feature, Vec2 a, Vec2 b, double radius, double sag);

/// Whether a ball that slides along the face to one of its ends there meets the circle without any approach,
/// since the circle is the end itself or goes on smoothly; `normal` is the face's towards the ball. Both in
/// the same pose.
[[nodiscard]] bool ends_in(const Feature& face, Vec2 normal, const Feature& circle);

/// How far a ball of this radius that lies on the feature at `point` can move along `direction` (unit) until
/// its end, m. A circle, which goes on from where a face ends, counts as one that is about to end.
[[nodiscard]] double ahead(const Feature& feature, Vec2 point, Vec2 direction, double radius);

/// The feature turned into a pose.
[[nodiscard]] Feature posed(const Feature& feature, const Pose& pose);

/// Smallest box around a feature of this primitive in the pose of the scene file.
[[nodiscard]] Box bounds_of(const Feature& feature, const Primitive& primitive);

}  // namespace flipside::custom
