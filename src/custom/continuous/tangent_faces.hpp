#pragma once
/// The straight static faces that a ball in free flight touches without a contact force.
///
/// Nothing accelerates the ball towards such a face, so its centre stays a radius above the line of the face
/// until another event changes its path, and it cannot reach features below that line. Rounding could still
/// give an impact with them: an end cap that continues the face is tangent to the path, and an overlap of one
/// rounding u there looks like an impact at an angle of sqrt(2u), 1e-8 rad.

#include <array>
#include <cstddef>

#include "custom/continuous/feature.hpp"

namespace flipside::custom {

class TangentFaces {
  public:
    void clear() { count_ = 0; }
    [[nodiscard]] bool any() const { return count_ > 0; }
    /// Adds a face through `at` with the unit normal towards the ball. A fifth face is ignored: a joint in a
    /// narrow channel has four.
    void add(Vec2 at, Vec2 normal) {
        if (count_ < faces_.size()) faces_[count_++] = {at, normal};
    }
    /// Whether a static feature, in the pose of the scene file, lies entirely below one of the faces, to
    /// rounding. Tests the full circle of an arc; returns false for a line.
    [[nodiscard]] bool above(const Feature& feature) const {
        const auto below = [&](Vec2 center, double radius) {
            for (std::size_t i = 0; i < count_; ++i) {
                const Vec2 from_face = center - faces_[i].at;
                const double size = std::abs(center.x) + std::abs(center.y) + length(from_face) + radius;
                if (dot(from_face, faces_[i].normal) + radius <= 64 * 0x1p-53 * size) return true;
            }
            return false;
        };
        if (const auto* circle = std::get_if<Circle>(&feature.is))
            return below(circle->center, circle->radius);
        if (const auto* arc = std::get_if<Arc>(&feature.is)) return below(arc->center, arc->radius);
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
