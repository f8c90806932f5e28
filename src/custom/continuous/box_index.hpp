#pragma once
/// Boxes that never change, searched for those that overlap one: a grid of about as many cells as boxes over
/// the table, each with the boxes that touch it. A box that touches too many cells is in none and is always
/// tested.
/// Cost: of making it, n + all entries in cells; of a search, the cells that the box touches and a test per
/// entry in them.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "custom/geometry/bounds.hpp"

namespace flipside::custom {

class BoxIndex {
  public:
    /// Most of the boxes lie in `range`; all others are found as well, with more tests.
    BoxIndex(const Box& range, std::vector<Box> boxes);

    [[nodiscard]] std::size_t size() const { return boxes_.size(); }
    [[nodiscard]] const Box& operator[](std::size_t i) const { return boxes_[i]; }

    /// Appends the indices of all that overlap `box`, in rising order. Returns the number of box tests; to
    /// find the cells counts as one.
    std::uint64_t find(const Box& box, std::vector<std::uint32_t>& found) const;

  private:
    struct Axis {
        double low = 0, per_cell = 0;
        std::size_t cells = 1;

        /// Of a coordinate; what is outside, at infinity too, is in the first or the last.
        [[nodiscard]] std::size_t cell(double at) const {
            const double place = (at - low) * per_cell;
            return place > 0 ? static_cast<std::size_t>(std::min(place, static_cast<double>(cells - 1))) : 0;
        }
    };
    [[nodiscard]] static Axis axis(double min, double max, double width, std::size_t most);
    void each_cell(const Box& box, auto&& visit) const;
    [[nodiscard]] std::span<const std::uint32_t> in_cell(std::size_t cell) const {
        return std::span(entries_).subspan(begins_[cell], begins_[cell + 1] - begins_[cell]);
    }

    std::vector<Box> boxes_;
    Axis x_, y_;
    std::vector<std::uint32_t> begins_;   ///< of each cell's entries, row by row, and their end
    std::vector<std::uint32_t> entries_;  ///< indices of boxes, cell by cell
    std::vector<std::uint32_t> large_;    ///< boxes that are in no cell
};

}  // namespace flipside::custom
