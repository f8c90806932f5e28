#pragma once
/// Features: the lines, arcs and circles of which every primitive consists for the continuous solver; points,
/// corners and caps are circles. The second derivative of the distance from a feature is bounded along any
/// smooth path. A disc of radius r touches a feature when the distance of its centre is r.
///
/// Solid shapes are represented by their outlines: a disc outside can only enter through the outline. A disc
/// that begins deep inside is found by the range of the first feature, which is that of the whole solid.

#include <array>
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
    Vec2 start;         ///< m
    Vec2 along;         ///< unit
    double length = 0;  ///< m
    EndExtension before, past;
};

/// Two-sided arc, anticlockwise between two unit directions.
struct Arc {
    Vec2 center;        ///< m
    double radius = 0;  ///< m
    Vec2 from, to;
    Vec2 middle;             ///< unit, half way between them
    double half_cosine = 0;  ///< of the angle from there to either
    EndExtension before, past;
    bool wide = false;  ///< spans more than half a turn
    bool full = false;  ///< has no ends
};

/// The outside of a circle; radius 0 is a point.
struct Circle {
    Vec2 center;        ///< m
    double radius = 0;  ///< m
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

/// The whole circle of an arc or circle.
[[nodiscard]] inline Circle circle_of(const Feature& feature) {
    const auto* arc = std::get_if<Arc>(&feature.is);
    return arc != nullptr ? Circle{arc->center, arc->radius} : std::get<Circle>(feature.is);
}

/// How a part turns during a window: at `rate` until `stop`, then not at all. Times are those of the window.
struct Turning {
    Pose begin;
    double rate = 0;       ///< rad/s
    double stop = 0;       ///< s
    double end_angle = 0;  ///< rad, from `stop` on

    [[nodiscard]] bool still() const { return rate == 0; }
    /// Whether the pose is that of the scene file throughout.
    [[nodiscard]] bool unmoved() const { return still() && begin.angle == 0; }
    [[nodiscard]] Pose pose(double time) const {
        return {begin.pivot, time < stop ? begin.angle + rate * time : end_angle};
    }
    [[nodiscard]] double rate_at(double time) const { return time < stop ? rate : 0; }
    /// Velocity of a point that turns with the part, m/s.
    [[nodiscard]] Vec2 velocity_at(Vec2 point, double time) const {
        return cross(rate_at(time), point - begin.pivot);
    }
};

/// Features in the order of the primitives. Cost: linear, but n log n in the number of ends.
[[nodiscard]] std::vector<Feature> features_of(std::span<const Primitive> primitives, const Scene& scene);

/// Result of a closest-point query.
struct Closest {
    double distance = 0;  ///< m, of the point from the curve without ends; negative inside a circle
    Vec2 normal;          ///< unit, from the curve to the point: the gradient of the distance
    bool facing = true;   ///< whether the closest point lies between the ends of the curve
};
[[nodiscard]] Closest closest_point(const Feature& feature, Vec2 point, double radius, const Pose& pose = {});

/// Cheap conservative test: true only if a disc whose centre stays within `sag` of the chord from a to b
/// cannot touch the feature (in the pose of the scene file).
[[nodiscard]] bool clear_of(const Feature& feature, Vec2 a, Vec2 b, double radius, double sag);

/// Whether the straight way from a to b crosses the curve of the feature (in the pose of the scene file).
[[nodiscard]] bool crosses(const Feature& feature, Vec2 a, Vec2 b);

/// Whether the circle continues the face smoothly at one of its ends, so that a ball that slides off the face
/// touches the circle without an approach speed. `normal` is that of the face towards the ball; both features
/// are in the same pose.
[[nodiscard]] bool continues_in(const Feature& face, Vec2 normal, const Feature& circle);

/// Distance from `point` on the feature to its end in `direction` (unit), m, for a ball of this radius. For a
/// circle it is almost 0, so that the faces that it joins take precedence.
[[nodiscard]] double distance_to_end(const Feature& feature, Vec2 point, Vec2 direction, double radius);

/// Bounds of all positions that each feature can have; for the first feature of a primitive, of all positions
/// of the whole primitive.
[[nodiscard]] std::vector<Box> ranges_of(std::span<const Feature> features,
                                         std::span<const Primitive> primitives, const Table& table);

/// The straight faces at rest that a ball in free flight touches without a contact force.
///
/// Nothing accelerates the ball towards such a face, so its centre stays a radius above the line of the face
/// until another event changes its path, and it cannot reach features below that line. Rounding could still
/// give an impact with them: an end cap that continues the face is tangent to the path, and an overlap of one
/// rounding u there looks like an impact at an angle of sqrt(2u), 1e-8 rad.
class TangentFaces {
  public:
    void clear() { count_ = 0; }
    /// Adds a face through `at` with the unit normal towards the ball. A fifth face is ignored: a joint in a
    /// narrow channel has four.
    void add(Vec2 at, Vec2 normal) {
        if (count_ < faces_.size()) faces_[count_++] = {at, normal};
    }
    /// Whether a feature at rest in this pose lies entirely below one of the faces, to rounding. Tests the
    /// full circle of an arc; returns false for a line.
    [[nodiscard]] bool above(const Feature& feature, const Pose& pose) const {
        if (count_ == 0 || std::holds_alternative<Line>(feature.is)) return false;
        const auto [in_scene, radius] = circle_of(feature);
        const Vec2 center = pose.apply(in_scene);
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 from_face = center - faces_[i].at;
            const double size = std::abs(center.x) + std::abs(center.y) + length(from_face) + radius;
            if (dot(from_face, faces_[i].normal) + radius <= 64 * 0x1p-53 * size) return true;
        }
        return false;
    }

  private:
    struct Face {
        Vec2 at, normal;
    };
    std::array<Face, 4> faces_{};
    std::size_t count_ = 0;
};

}  // namespace flipside::custom
