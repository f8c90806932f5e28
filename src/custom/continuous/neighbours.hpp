#pragma once
/// Neighbour search: what a ball may touch soon. Cells find the other balls, a BoxIndex the features of
/// parts.

#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "custom/geometry/cell_range.hpp"
#include "world/ball.hpp"
#include "world/bounds.hpp"
#include "world/inspector.hpp"

namespace flipside::custom {

using BallIndex = std::uint32_t;  ///< of a ball in Simulation::balls

/// Finds the balls near a ball by a hierarchical hash grid: square cells, on levels whose widths double
/// (Ericson 2005, "Real-time collision detection", 7.2). A ball is listed on the level whose cells are just
/// wider than 1.25 diameters (or than its path in a millisecond, if that is longer), in the cell that
/// contains its centre. It stays listed there until its centre is a tenth of a width outside (Rapaport 1980,
/// "The event scheduling problem in molecular dynamic simulation"). All balls that it may touch until then
/// are listed, on its own level, in that cell or one of the eight around it; on another level, in the cells
/// within half of both widths.
///
/// The grid is unbounded: a hash table maps level, column and row to a list. Columns and rows count modulo
/// 2²⁸, so cells that far apart share a list, which costs tests and changes no result.
///
/// Cost: constant for a ball that changes its cell. A query visits nine cells on its own level, about four on
/// each coarser level in use, and on a finer level those that the ball covers, or all balls where these are
/// few.
class Cells {
  public:
    struct Cell {
        std::uint32_t level = 0;
        std::int64_t column = 0, row = 0;
        friend auto operator<=>(const Cell&, const Cell&) = default;
    };

    static constexpr BallIndex none = ~BallIndex{0};
    static constexpr std::uint64_t unlisted = ~std::uint64_t{0};
    /// A ball in the list of its cell.
    struct Link {
        std::uint64_t key = unlisted;  ///< of the cell: level, column, row
        BallIndex next = none, previous = none;
    };

    void reserve(std::size_t balls);
    /// Starts with these balls, none of them listed.
    void reset(std::span<const Ball> balls);
    /// The level whose cells are at least `width` wide, m.
    [[nodiscard]] std::uint32_t level_for(double width) const;
    /// Lists a ball in the cell of this level that contains `center`, and in no other.
    void insert(BallIndex i, std::uint32_t level, Vec2 center);
    void remove(BallIndex i);
    [[nodiscard]] const Cell& operator[](BallIndex i) const { return cells_[i]; }
    [[nodiscard]] const Link& link(BallIndex i) const { return links_[i]; }
    /// Draws the cells in use, each with the number of its balls.
    void inspect(Inspector& inspector) const;
    /// The least width for a ball of this radius.
    [[nodiscard]] static double width_for(double radius);

    /// Lower bound on the time for which a ball stays in its cell, s. Its centre is at `center` now, and
    /// neither component of its acceleration exceeds `top` (m/s²). Positive right after insert(), unless
    /// coordinates are so large that rounding is as wide as a cell.
    [[nodiscard]] double time_in_cell(BallIndex i, Vec2 center, Vec2 velocity, Vec2 top) const;

    /// Visits all balls that ball i may touch while both stay in their cells, and some others, in any order.
    void query_neighbours(BallIndex i, auto&& visit) const {
        query(i, visit, [](std::int64_t, std::int64_t) { return true; });
    }
    /// The same, but only those that a query from the cell `before` would not have visited.
    void query_new_neighbours(BallIndex i, const Cell& before, auto&& visit) const {
        query(i, visit, [&](std::int64_t column, std::int64_t row) {
            return std::abs(column - before.column) > 1 || std::abs(row - before.row) > 1;
        });
    }
    /// Visits the neighbours of each ball i of a list, also of those that `visit(i, j)` adds to it (flood
    /// fill).
    void flood_fill(const std::vector<BallIndex>& list, auto&& visit) const {
        for (std::size_t seen = 0; seen < list.size();) {
            const BallIndex i = list[seen++];
            query_neighbours(i, [&](BallIndex j) { visit(i, j); });
        }
    }

  private:
    static constexpr int index_bits = 28;
    static constexpr std::uint32_t index_mask = (1U << index_bits) - 1;
    static constexpr std::uint32_t most_levels = 128;

    struct Level {
        std::uint32_t number = 0;
        std::size_t balls = 0;
    };

    [[nodiscard]] static std::uint64_t key_of(const Cell& cell) {
        return std::uint64_t{cell.level} << 2 * index_bits |
               (static_cast<std::uint64_t>(cell.column) & index_mask) << index_bits |
               (static_cast<std::uint64_t>(cell.row) & index_mask);
    }
    /// Cells of one row have adjacent buckets.
    [[nodiscard]] std::size_t bucket(const Cell& cell) const {
        constexpr std::uint64_t spread = 0x9e3779b97f4a7c15;  // 2⁶⁴ by the golden ratio
        const std::uint64_t line =
            (static_cast<std::uint64_t>(cell.row) & index_mask) * most_levels + cell.level;
        return ((static_cast<std::uint64_t>(cell.column) & index_mask) + (line * spread >> 20)) & mask_;
    }
    [[nodiscard]] static std::int64_t index_at(double coordinate, double width);

    void each_in(const Cell& cell, BallIndex except, auto& visit) const {
        const std::uint64_t key = key_of(cell);
        for (BallIndex j = heads_[bucket(cell)]; j != none; j = links_[j].next)
            if (links_[j].key == key && j != except) visit(j);
    }
    void query(BallIndex i, auto& visit, auto&& is_wanted) const {
        for (const Level& level : levels_) {
            if (level.number == cells_[i].level)
                each_around(cells_[i], i, visit, is_wanted);
            else
                each_on_other(level, i, visit);
        }
    }
    /// `is_wanted` chooses among the nine cells.
    void each_around(const Cell& at, BallIndex except, auto& visit, auto& is_wanted) const {
        constexpr std::size_t few = 4;  // balls: a cell takes about as long as two of them
        if (links_.size() <= few)
            return each_on_level(at.level, except, [&](BallIndex j) {
                const auto [level, column, row] = cells_[j];
                if (std::abs(column - at.column) <= 1 && std::abs(row - at.row) <= 1 &&
                    is_wanted(column, row))
                    visit(j);
            });
        for (std::int64_t row = at.row - 1; row <= at.row + 1; ++row)
            for (std::int64_t column = at.column - 1; column <= at.column + 1; ++column)
                if (is_wanted(column, row)) each_in({at.level, column, row}, except, visit);
    }
    /// For where the balls are fewer than the cells to visit.
    void each_on_level(std::uint32_t level, BallIndex except, auto&& visit) const {
        for (BallIndex j = 0; j < links_.size(); ++j)
            if (links_[j].key != unlisted && cells_[j].level == level && j != except) visit(j);
    }
    void each_on_other(const Level& level, BallIndex i, auto& visit) const {
        const Cell& at = cells_[i];
        const double own = widths_[at.level], other = widths_[level.number], reach = (own + other) / 2;
        const auto first = [&](std::int64_t index) {
            return index_at(static_cast<double>(index) * own - reach, other);
        };
        const auto last = [&](std::int64_t index) {
            return index_at(static_cast<double>(index + 1) * own + reach, other);
        };
        const std::int64_t left = first(at.column), right = last(at.column);
        const std::int64_t low = first(at.row), high = last(at.row);
        const double cells = static_cast<double>(right - left + 1) * static_cast<double>(high - low + 1);
        if (cells > static_cast<double>(links_.size())) return each_on_level(level.number, i, visit);
        for (std::int64_t row = low; row <= high; ++row)
            for (std::int64_t column = left; column <= right; ++column)
                each_in({level.number, column, row}, i, visit);
    }
    void count(std::uint32_t number, int change);

    std::array<double, most_levels> widths_{};  ///< m, by level
    std::vector<Link> links_;                   ///< per ball
    std::vector<Cell> cells_;                   ///< per ball
    std::vector<BallIndex> heads_;              ///< per bucket, a power of two of them
    std::uint64_t mask_ = 0;
    std::vector<Level> levels_;  ///< in use
};

/// Finds the features near a ball among boxes that never change. Square cells cover their range, on levels
/// whose widths double. Each cell lists all boxes that overlap it or a margin of about half a width around
/// it. So a query reads one list, that of the narrowest cell which contains the box together with this
/// margin.
///
/// Cost: a query takes a constant time per level that is too narrow for its box. A small box is in four to
/// nine lists per level, a wall in two or three per cell along it. Levels with too many cells or entries are
/// left out.
class BoxIndex {
  public:
    /// No box is empty. Boxes outside `range` are found too, with more tests. `width`: of the narrowest
    /// cells, m.
    BoxIndex(const Box& range, double width, std::vector<Box> boxes);

    [[nodiscard]] std::size_t size() const { return boxes_.size(); }
    [[nodiscard]] const Box& operator[](std::size_t i) const { return boxes_[i]; }

    /// The indices of all boxes that overlap `box`, and of some others, in rising order.
    [[nodiscard]] std::span<const std::uint32_t> near(const Box& box) const;

  private:
    struct Level {
        double width = 0, per_width = 0;  ///< m, 1/m
        Vec2 low;                         ///< corner of the first cell, a multiple of the width
        std::uint32_t columns = 1, rows = 1;
        std::vector<std::uint32_t> begins;   ///< index of each cell's first entry, row by row, and of the end
        std::vector<std::uint32_t> entries;  ///< cell by cell

        [[nodiscard]] std::size_t cell(std::uint32_t at_column, std::uint32_t at_row) const {
            return std::size_t{at_row} * columns + at_column;
        }
    };
    [[nodiscard]] Box clamped(const Box& box) const;
    /// Lists the boxes in the cells of a level, unless these or their entries are more than `most`.
    [[nodiscard]] bool fill(Level& level, double most) const;

    Box range_;  ///< of the cells
    std::vector<Box> boxes_;
    std::vector<Level> levels_;
};

}  // namespace flipside::custom
