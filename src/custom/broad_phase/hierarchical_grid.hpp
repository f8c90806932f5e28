#pragma once
/// A hierarchical grid: boxes of any sizes that move one at a time, searched for those that overlap a box
/// (Ericson 2005, "Real-Time Collision Detection", 7.2.1).
///
/// A box is listed in one cell, that of its centre, on the level whose cells are the narrowest of a power of
/// two that are wider than it: so it reaches half a cell beyond its own at most. A query looks, on every
/// level in use, at the cells within half a cell of its box. The levels have no border: cells are kept in a
/// hash table, and boxes anywhere and of sizes thousands of times apart need no more memory than others.
///
/// Cost: constant for a box that moves; a query looks at about nine cells on the level of its own size and
/// four on a coarser one, and at more on a finer one. It never costs more than a test of every box. Few boxes
/// are not put into cells.
///
/// Positions must be below 10¹⁴ box widths, or rounding may put a box into a cell that is not its own.

#include <cstdint>
#include <vector>

#include "custom/geometry/bounds.hpp"

namespace flipside::custom {

class HierarchicalGrid {
  public:
    using Index = std::uint32_t;

    /// Makes room for so many boxes.
    void reserve(std::size_t boxes);
    /// Forgets all boxes. Then there are `count`, which overlap nothing until they are placed.
    void reset(std::size_t count);
    void place(Index i, const Box& box);
    /// Forgets the boxes from `count` on.
    void shrink(std::size_t count);

    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    [[nodiscard]] const Box& operator[](Index i) const { return entries_[i].box; }

    /// Writes the indices of all boxes that overlap `box` to `found`, in rising order. Returns the number of
    /// tests of one box against another.
    std::uint64_t find(const Box& box, std::vector<Index>& found) const;
    /// Whether any overlaps `box` but that of `except`.
    [[nodiscard]] bool any(const Box& box, Index except) const;

  private:
    static constexpr Index none = ~Index{0};

    struct Cell {
        int exponent = 0;  ///< the level: cells are 2^exponent m wide
        std::int64_t column = 0, row = 0;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct Entry {
        Box box;
        Cell cell;
        Index next = none, previous = none;  ///< with the same hash
        bool listed = false;
    };
    struct Level {
        int exponent = 0;
        std::size_t boxes = 0;
    };
    /// Cells from the first to the last column and row.
    struct Range {
        Cell first, last;
        [[nodiscard]] double cells() const;
    };

    [[nodiscard]] static Cell cell_of(const Box& box);
    [[nodiscard]] static Range cells_near(const Box& box, int exponent);
    [[nodiscard]] std::size_t bucket(const Cell& cell) const;
    void link(Index i);
    void unlink(Index i);
    void count(int exponent, int change);
    std::uint64_t each_overlap(const Box& box, auto&& visit) const;

    std::vector<Entry> entries_;
    std::vector<Index> heads_;   ///< by bucket, a power of two of them; none where boxes are few
    std::vector<Level> levels_;  ///< in use
};

}  // namespace flipside::custom
