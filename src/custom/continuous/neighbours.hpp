#pragma once
/// Neighbour search: what a ball may touch soon. Cells find the other balls, a BoxIndex the features of
/// parts.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "custom/broad_phase/cell_lists.hpp"
#include "custom/geometry/bounds.hpp"
#include "world/ball.hpp"
#include "world/inspector.hpp"

namespace flipside::custom {

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
/// each coarser level in use, and on a finer level those that the ball covers, or all balls if these are
/// fewer.
class Cells {
  public:
    using BallIndex = std::uint32_t;

    struct Cell {
        std::uint32_t level = 0;
        std::int64_t column = 0, row = 0;
        friend auto operator<=>(const Cell&, const Cell&) = default;
    };

    /// Reserves memory for so many balls.
    void reserve(std::size_t balls);
    /// Starts with these balls, none of them listed.
    void reset(std::span<const Ball> balls);
    /// Sets the level of a ball, so that its cells are at least `width` wide, m. Removes the ball from its
    /// list if the level changes.
    void choose_level(BallIndex i, double width);
    /// Lists a ball in the cell that contains `center`.
    void insert(BallIndex i, Vec2 center);
    void remove(BallIndex i);
    [[nodiscard]] const Cell& operator[](BallIndex i) const { return cells_[i]; }
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

  private:
    static constexpr BallIndex none = ~BallIndex{0};
    static constexpr int index_bits = 28;
    static constexpr std::uint32_t index_mask = (1U << index_bits) - 1;
    static constexpr std::uint32_t most_levels = 128;

    struct Link {
        std::uint64_t key = unlisted;  ///< of the cell: level, column, row
        BallIndex next = none, previous = none;
    };
    static constexpr std::uint64_t unlisted = ~std::uint64_t{0};
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
        for (std::int64_t row = at.row - 1; row <= at.row + 1; ++row)
            for (std::int64_t column = at.column - 1; column <= at.column + 1; ++column)
                if (is_wanted(column, row)) each_in({at.level, column, row}, except, visit);
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
        if (cells > static_cast<double>(links_.size())) {
            for (BallIndex j = 0; j < links_.size(); ++j)
                if (links_[j].key != unlisted && cells_[j].level == level.number && j != i) visit(j);
            return;
        }
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

/// Finds the parts near a ball by a static grid of boxes that never change. It has about half as many
/// cells as boxes; each cell lists the boxes that touch it. A box that touches too many cells is in no list
/// and is tested in every query. Cost: n + all list entries to build it; a query costs one test per box
/// listed in the cells that it touches.
class BoxIndex {
  public:
    /// Most of the boxes should lie in `range`; others are found too, with more tests.
    BoxIndex(const Box& range, std::vector<Box> boxes);

    [[nodiscard]] std::size_t size() const { return boxes_.size(); }
    [[nodiscard]] const Box& operator[](std::size_t i) const { return boxes_[i]; }

    /// Appends the indices of all boxes that overlap `box`, in rising order. Returns the number of box tests;
    /// finding the cells counts as one. In between `found` grows by up to one more than size().
    std::uint64_t find(const Box& box, std::vector<std::uint32_t>& found) const;

  private:
    struct Axis {
        double low = 0, per_cell = 0;
        std::uint32_t cells = 1;

        /// Index of the cell of a coordinate; the first or the last for those outside, also at infinity.
        [[nodiscard]] std::uint32_t cell(double at) const {
            const double index = (at - low) * per_cell;
            return index > 0 ? static_cast<std::uint32_t>(std::min(index, cells - 1.0)) : 0;
        }
    };
    [[nodiscard]] static Axis axis(double min, double max, double width, std::size_t most);
    /// A box in the list of a cell of this column, and the first column and row that it touches.
    struct Entry {
        std::uint32_t index = 0;
        std::uint32_t column = 0, left = 0, low = 0;
    };
    [[nodiscard]] CellRange cells_of(const Box& box) const {
        return {x_.cell(box.min.x), y_.cell(box.min.y), x_.cell(box.max.x), y_.cell(box.max.y)};
    }
    [[nodiscard]] std::size_t cell_at(std::uint32_t column, std::uint32_t row) const {
        return std::size_t{row} * x_.cells + column;
    }
    /// The entries of these cells, which are adjacent.
    [[nodiscard]] std::span<const Entry> in_row(const CellRange& cells, std::uint32_t row) const {
        const std::uint32_t begin = begins_[cell_at(cells.left, row)];
        return std::span(entries_).subspan(begin, begins_[cell_at(cells.right, row) + 1] - begin);
    }

    std::vector<Box> boxes_;
    Axis x_, y_;
    std::vector<std::uint32_t> begins_;  ///< index of each cell's first entry, row by row, and the end of all
    std::vector<Entry> entries_;         ///< cell by cell
    std::vector<std::uint32_t> large_;   ///< boxes in no cell, tested in every query
};

/// The boxes of an index that a ball may touch: those that overlap its fat AABB. The list is rebuilt only
/// when the swept bounds of its path leave that box, which happens once in many steps. A short list lies
/// beside that box, so that a query takes one or two cache lines.
class Candidates {
  public:
    /// Reserves memory for lists of so many boxes.
    void reserve(std::size_t boxes) {
        if (boxes > most_short) long_list_.reserve(boxes);
    }
    /// All boxes of the index that overlap `box`, and some others, in rising order; valid until the next
    /// call. The ball moves at `velocity`. Adds the number of box tests to `tests`. `found` is a buffer.
    [[nodiscard]] std::span<const std::uint32_t> near(const Box& box, Vec2 velocity, const BoxIndex& index,
                                                      std::vector<std::uint32_t>& found,
                                                      std::uint64_t& tests);
    void forget() { fat_ = nothing; }

  private:
    static constexpr std::size_t most_short = 17;  // on pinball 5 % of all lists are longer
    static constexpr Box nothing{{1, 1}, {-1, -1}};
    [[nodiscard]] std::span<const std::uint32_t> list() const {
        return count_ > most_short ? std::span(long_list_) : std::span(short_list_).first(count_);
    }

    Box fat_ = nothing;
    std::uint32_t count_ = 0;
    std::array<std::uint32_t, most_short> short_list_{};
    std::vector<std::uint32_t> long_list_;
};

}  // namespace flipside::custom
