#pragma once
/// Static grid of boxes that never change, to find those that overlap a query box. It has about as many cells
/// as boxes; each cell lists the boxes that touch it. A box that touches too many cells is in no list and is
/// tested in every query. Cost: n + all list entries to build it; a query costs one box test per entry in the
/// cells that it touches.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "custom/geometry/bounds.hpp"

namespace flipside::custom {

class BoxIndex {
  public:
    /// Most of the boxes should lie in `range`; others are found too, with more tests.
    BoxIndex(const Box& range, std::vector<Box> boxes);

    [[nodiscard]] std::size_t size() const { return boxes_.size(); }
    [[nodiscard]] const Box& operator[](std::size_t i) const { return boxes_[i]; }

    /// Appends the indices of all boxes that overlap `box`, in rising order. Returns the number of box tests;
    /// finding the cells counts as one.
    std::uint64_t find(const Box& box, std::vector<std::uint32_t>& found) const;

  private:
    struct Axis {
        double low = 0, per_cell = 0;
        std::size_t cells = 1;

        /// Index of the cell of a coordinate; the first or the last for those outside, also at infinity.
        [[nodiscard]] std::size_t cell(double at) const {
            const double index = (at - low) * per_cell;
            return index > 0 ? static_cast<std::size_t>(std::min(index, static_cast<double>(cells - 1))) : 0;
        }
    };
    [[nodiscard]] static Axis axis(double min, double max, double width, std::size_t most);
    void each_cell(const Box& box, auto&& visit) const;
    [[nodiscard]] std::span<const std::uint32_t> in_cell(std::size_t cell) const {
        return std::span(entries_).subspan(begins_[cell], begins_[cell + 1] - begins_[cell]);
    }

    std::vector<Box> boxes_;
    Axis x_, y_;
    std::vector<std::uint32_t> begins_;  ///< index of each cell's first entry, row by row, and the end of all
    std::vector<std::uint32_t> entries_;  ///< indices of boxes, cell by cell
    std::vector<std::uint32_t> large_;    ///< boxes in no cell, tested in every query
};

/// The boxes of an index that a ball may touch: those that overlap its fat AABB. The list is rebuilt only
/// when the swept bounds of its path leave that box, which happens once in many steps.
class Candidates {
  public:
    /// Rebuilds the list if `box` is not inside the fat AABB. Returns the number of box tests.
    std::uint64_t cover(const Box& box, const BoxIndex& index);
    void reserve(std::size_t boxes) { list_.reserve(boxes); }
    void forget() { fat_ = {{1, 1}, {-1, -1}}; }

    /// In rising order.
    [[nodiscard]] std::span<const std::uint32_t> list() const { return list_; }

  private:
    Box fat_{{1, 1}, {-1, -1}};
    std::vector<std::uint32_t> list_;
};

}  // namespace flipside::custom
