#pragma once
/// The straight still faces that a ball in free flight touches without pressing on them.
///
/// Nothing drives the ball into such a face, so its centre stays a radius above the face's line until
/// something else changes its path. Whatever lies below that line is out of its reach. Rounding does not
/// know that: an end cap that continues the face is tangent to the path, and a depth of one rounding u
/// there is met at an angle of sqrt(2u), 1e-8 rad.

#include <array>
#include <cstddef>

#include "custom/continuous/feature.hpp"

namespace flipside::custom {

class Glides {
  public:
    void clear() { count_ = 0; }
    [[nodiscard]] bool any() const { return count_ > 0; }
    /// A face through `at` with the unit normal towards the ball. Beyond the fourth, faces are ignored: a
    /// joint in a narrow channel has four.
    void add(Vec2 at, Vec2 normal) {
        if (count_ < faces_.size()) faces_[count_++] = {at, normal};
    }
    /// Whether the whole feature, which stands still in the pose of the scene file, lies below one of the
    /// faces, to rounding. Of an arc its circle counts; of a line this says false.
    [[nodiscard]] bool above(const Feature& feature) const;

  private:
    struct Face {
        Vec2 at, normal;
    };
    std::array<Face, 4> faces_{};
    std::size_t count_ = 0;
};

}  // namespace flipside::custom
