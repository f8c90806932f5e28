#pragma once
/// Lists of proxies per cell, and a base for broad phases that list a proxy in every cell that its box
/// overlaps. A pair that shares several cells is tested only in the first of them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

/// Columns and rows of cells, both ends included.
struct CellRange {
    std::uint32_t left = 0, low = 0, right = 0, high = 0;

    [[nodiscard]] std::uint64_t count() const {
        return std::uint64_t{right - left + 1} * std::uint64_t{high - low + 1};
    }
    /// Visits the cells row by row.
    void each(auto&& visit) const {
        for (std::uint32_t row = low; row <= high; ++row)
            for (std::uint32_t column = left; column <= right; ++column) visit(column, row);
    }
};

/// Whether (column, row) is the first cell that two ranges share, in the order of each().
[[nodiscard]] inline bool is_first_shared(const CellRange& a, const CellRange& b, std::uint32_t column,
                                          std::uint32_t row) {
    return column == std::max(a.left, b.left) && row == std::max(a.low, b.low);
}

/// Index of the cell at `offset` from the border. Offsets outside, even at infinity, give the outermost
/// cells.
[[nodiscard]] inline std::uint32_t cell_index(double offset, double width, std::uint32_t cells) {
    const double at = std::floor(offset / width);
    return at > 0 ? static_cast<std::uint32_t>(std::min(at, cells - 1.0)) : 0;
}

struct CellLists {
    static constexpr std::uint32_t none = ~0U;
    struct Link {
        Handle proxy;
        std::uint32_t next;
    };
    std::vector<std::uint32_t> first;  ///< per cell: index into links, or none
    std::vector<Link> links;

    void reset(std::size_t cells) {
        first.assign(cells, none);
        links.clear();
    }
    /// Adds to the front of a list.
    void add(std::uint32_t cell, Handle proxy) {
        links.push_back({proxy, first[cell]});
        first[cell] = static_cast<std::uint32_t>(links.size() - 1);
    }
    void each(std::uint32_t cell, auto&& visit) const { each_from(first[cell], visit); }
    void each_from(std::uint32_t link, auto&& visit) const {
        for (; link != none; link = links[link].next) visit(links[link]);
    }
    [[nodiscard]] int count(std::uint32_t cell) const {
        int n = 0;
        each(cell, [&](const Link&) { ++n; });
        return n;
    }
};

class CellBroadPhase : public BroadPhase {
  protected:
    using BroadPhase::BroadPhase;

    /// Number of proxies that a cell lists.
    [[nodiscard]] int count(std::uint32_t cell) const {
        return still_lists_.count(cell) + moving_lists_.count(cell);
    }
    /// Tests the pairs of which this is the first shared cell. `node`: its index among those of tree().
    void search_cell(std::uint32_t cell, std::uint32_t column, std::uint32_t row,
                     std::uint32_t node = no_cell) {
        most_in_cell_ = std::max(most_in_cell_, count(cell));
        moving_lists_.each(cell, [&](CellLists::Link b) {
            const CellRange& range = moving_cells_[b.proxy];
            still_lists_.each(cell, [&](CellLists::Link a) {
                if (is_first_shared(still_cells_[a.proxy], range, column, row))
                    test_still(a.proxy, b.proxy, node);
            });
            moving_lists_.each_from(b.next, [&](CellLists::Link a) {
                if (is_first_shared(moving_cells_[a.proxy], range, column, row))
                    test_moving(a.proxy, b.proxy, node);
            });
        });
    }

    CellLists still_lists_, moving_lists_;
    std::vector<CellRange> still_cells_, moving_cells_;  ///< per proxy
    int most_in_cell_ = 0;
};

}  // namespace flipside::custom
