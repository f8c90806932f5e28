#pragma once
/// The features that a ball may touch: those that overlap its fat AABB. The list is rebuilt only when the
/// swept bounds of its path leave that box, which happens once in many steps.

#include "custom/continuous/box_index.hpp"
#include "custom/continuous/feature.hpp"
#include "custom/geometry/bounds.hpp"

namespace flipside::custom {

using FeatureIndex = std::uint32_t;

/// Bounds of all positions that a feature of this primitive can have.
[[nodiscard]] Box range_of(const Feature& feature, const Primitive& primitive, const Table& table);

class Candidates {
  public:
    /// Rebuilds the list if `box` is not inside the fat AABB. Returns the number of box tests.
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
