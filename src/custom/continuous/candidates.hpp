#pragma once
/// Which features a ball can meet: a list per ball of those that its fat box touches, made again only
/// when its path leaves that box, which is once in many steps.

#include "custom/continuous/box_index.hpp"
#include "custom/continuous/feature.hpp"
#include "custom/continuous/path.hpp"
#include "custom/geometry/bounds.hpp"

namespace flipside::custom {

using FeatureIndex = std::uint32_t;

/// Box around all places that a feature of this primitive can ever be at.
[[nodiscard]] Box range_of(const Feature& feature, const Primitive& primitive, const Table& table);

/// Box around a ball on its path until `end`.
[[nodiscard]] Box bounds_of(const Path& path, double radius, double end);

class Candidates {
  public:
    /// Makes sure that the list holds for a path within `box`. Returns the number of box tests.
    std::uint64_t cover(const Box& box, const BoxIndex& feature_ranges);
    void reserve(std::size_t features) { list_.reserve(features); }
    void forget() { fat_ = {{1, 1}, {-1, -1}}; }

    /// In rising order.
    [[nodiscard]] std::span<const FeatureIndex> list() const { return list_; }

  private:
    Box fat_{{1, 1}, {-1, -1}};
    std::vector<FeatureIndex> list_;
};

}  // namespace flipside::custom
