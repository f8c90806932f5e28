#pragma once
/// Lists of proxies per cell, for the leaves of the quadtree and for the grid. A proxy is listed in every
/// cell that its box overlaps: still proxies once, moving ones again in every search. There a moving proxy is
/// tested against those listed before it; a pair that shares several cells is tested only in the first of
/// them. Finding the cells under a box needs its four coordinates once, and counts as one box test.

#include <algorithm>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/geometry/cell_range.hpp"

namespace flipside::custom {

class CellBroadPhase : public BroadPhase {
  protected:
    CellBroadPhase(std::vector<Proxy> still, const Box& world)
        : BroadPhase(std::move(still)), world_(world) {}

    /// Prepares a search: may divide the world anew.
    virtual void fit_cells() {}
    /// Lists a proxy in the cells of this range, those under its box.
    virtual void insert(Handle b, const CellRange& range) = 0;

    /// Divides the world into cells of this size, m, and lists the still proxies in them.
    void set_cells(Vec2 size, std::uint32_t columns, std::uint32_t rows) {
        size_ = size, columns_ = columns, rows_ = rows;
        lists_.assign(std::size_t{columns} * rows, {});
        links_.clear();
        ranges_.clear();
        most_in_cell_ = 0;
        insert_all(0, first_moving_);
        most_still_ = most_in_cell_;
    }
    /// Lists proxy b in a cell under it, and if it moves, tests it against those that are listed there
    /// already, unless both are in an earlier cell too. `node`: the index of the cell among those of a tree.
    void list(Handle b, std::uint32_t cell, std::uint32_t column, std::uint32_t row,
              std::uint32_t node = no_cell) {
        const CellRange range = ranges_[b];
        List& listed = lists_[cell];
        const std::uint32_t first = b < first_moving_ ? none : listed.first;
        for (std::uint32_t link = first; link != none; link = links_[link].next) {
            const Handle a = links_[link].proxy;
            if (column == std::max(ranges_[a].left, range.left) && row == std::max(ranges_[a].low, range.low))
                test(a, b, node);
        }
        links_.push_back({b, listed.first, cell});
        listed = {static_cast<std::uint32_t>(links_.size() - 1), listed.count + 1};
        most_in_cell_ = std::max(most_in_cell_, listed.count);
    }
    /// Number of proxies in a cell.
    [[nodiscard]] int count(std::uint32_t cell) const { return lists_[cell].count; }

    Box world_;
    Vec2 size_;  ///< m, of a cell
    std::uint32_t columns_ = 1, rows_ = 1;
    int most_in_cell_ = 0;

  private:
    static constexpr std::uint32_t none = ~0U;
    struct List {
        std::uint32_t first = none;  ///< index into links_
        int count = 0;
    };
    struct Link {
        Handle proxy;
        std::uint32_t next, cell;
    };

    void search() final {
        for (; !links_.empty() && links_.back().proxy >= first_moving_; links_.pop_back()) {
            List& cell = lists_[links_.back().cell];
            cell = {links_.back().next, cell.count - 1};
        }
        ranges_.resize(first_moving_);
        most_in_cell_ = most_still_;
        fit_cells();
        reserve_for(ranges_, proxies_.size());
        reserve_for(links_, proxies_.size(), pairs_per_ball);
        insert_all(first_moving_, static_cast<Handle>(proxies_.size()));
        tests_ += moving();
    }
    void insert_all(Handle begin, Handle end) {
        for (Handle b = begin; b < end; ++b) {
            ranges_.push_back(cells_under(proxies_[b].box));
            insert(b, ranges_[b]);
        }
    }
    /// The cells under a box. Boxes outside the world, even at infinity, are in the outermost cells.
    [[nodiscard]] CellRange cells_under(const Box& box) const {
        const Vec2 min = box.min - world_.min, max = box.max - world_.min;
        return {cell_index(min.x / size_.x, columns_), cell_index(min.y / size_.y, rows_),
                cell_index(max.x / size_.x, columns_), cell_index(max.y / size_.y, rows_)};
    }

    std::vector<CellRange> ranges_;  ///< by handle
    std::vector<List> lists_;        ///< by cell
    std::vector<Link> links_;        ///< those of still proxies first
    int most_still_ = 0;             ///< still proxies in a cell
};

}  // namespace flipside::custom
