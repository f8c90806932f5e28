// A uniform grid of square cells. A proxy is listed in every cell that its box overlaps. Still proxies are
// listed once; moving ones are cleared and listed again for every search. Pairs are sought cell by cell, in
// those cells alone that list a moving proxy, and a pair that shares several cells is looked at only in the
// first of them. A box over more than `most_cells` cells is wide: it is listed nowhere and tested against
// all others.
//
// The cells under a box follow from its corners, which takes the four coordinates once, as one box test does,
// and is counted as one.
// Cost: O(n · cells per box + pairs sharing a cell); wide boxes cost O(n) each.
// Bentley, Friedman 1979, "Data structures for range searching", 2.3; Ericson 2005, "Real-time collision
// detection", 7.1.

#include <algorithm>
#include <cmath>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/broad_phase/capacity.hpp"

namespace flipside::custom {

namespace {

/// Columns and rows of cells, both ends included.
struct CellRange {
    std::uint32_t left = 0, bottom = 0, right = 0, top = 0;
    [[nodiscard]] std::uint64_t count() const {
        return std::uint64_t{right - left + 1} * std::uint64_t{top - bottom + 1};
    }
};

class Grid final : public BroadPhase {
  public:
    Grid(std::vector<Proxy> still, const Box& world, double cell)
        : still_(std::move(still)), world_(world), fits_cells_(cell == 0) {
        const Vec2 size = world.max - world.min;
        set_cells(cell > 0 ? cell : std::max(size.x, size.y));
    }

    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) override {
        pairs.clear();
        clear_moving();
        fit_cells(moving);
        if (std::ranges::none_of(moving, &Proxy::active)) return;
        moving_ = moving;
        reserve_for(moving_lists_.links, moving.size(), pairs_per_ball);
        reserve_for(occupied_, moving.size(), pairs_per_ball);
        reserve_for(moving_cells_, moving.size());
        reserve_for(wide_, moving.size());
        for (Handle i = 0; i < moving.size(); ++i) insert(i);
        most_in_cell_ = 0;
        for (const std::uint32_t cell : occupied_) search_cell(cell, pairs);
        search_wide(pairs);
        std::ranges::sort(pairs);
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        return {.name = "grid",
                .leaves = static_cast<int>(columns_ * rows_),
                .leaf_width = cell_,
                .leaf_height = cell_,
                .most_in_leaf = most_in_cell_};
    }

    void inspect(Inspector& inspector) const override {
        if (fits_cells_ && fitted_for_ == 0) return;  // to nothing yet
        for (std::uint32_t row = 0; row < rows_; ++row)
            for (std::uint32_t column = 0; column < columns_; ++column) {
                const Vec2 corner =
                    world_.min + cell_ * Vec2{static_cast<double>(column), static_cast<double>(row)};
                inspector.cell({corner, corner + Vec2{cell_, cell_}}, count(row * columns_ + column));
            }
    }

  private:
    static constexpr std::uint32_t nobody = ~0U;
    static constexpr std::uint64_t most_cells = 64;  ///< under a box that is listed
    /// What each cell lists.
    struct Lists {
        struct Link {
            Handle proxy;
            std::uint32_t next;
        };
        std::vector<std::uint32_t> first;  ///< per cell: into links, or nobody
        std::vector<Link> links;

        void add(std::uint32_t cell, Handle proxy) {
            links.push_back({proxy, first[cell]});
            first[cell] = static_cast<std::uint32_t>(links.size() - 1);
        }
        /// From the link `from` on; lists grow at their front, so handles fall.
        void each(std::uint32_t from, auto&& visit) const {
            for (std::uint32_t i = from; i != nobody; i = links[i].next) visit(links[i]);
        }
    };

    /// Chooses the cells and lists the still proxies in them. At most 2^22 cells: too narrow ones are
    /// widened.
    void set_cells(double cell) {
        const Vec2 size = world_.max - world_.min;
        cell_ = std::max({cell, std::sqrt(size.x * size.y) * 0x1p-11, std::max(size.x, size.y) * 0x1p-16});
        const auto cells_along = [&](double length) {
            return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / cell_)));
        };
        columns_ = cells_along(size.x), rows_ = cells_along(size.y);
        for (Lists* lists : {&still_lists_, &moving_lists_}) {
            lists->first.assign(columns_ * rows_, nobody);
            lists->links.clear();
        }
        still_cells_.clear();
        wide_still_.clear();
        for (Handle i = 0; i < still_.size(); ++i) {
            still_cells_.push_back(cells_under(still_[i].box));
            if (still_cells_.back().count() > most_cells)
                wide_still_.push_back(i);
            else
                each_cell(still_cells_.back(), [&](std::uint32_t at) { still_lists_.add(at, i); });
        }
    }

    /// Fits the cells to the median of the boxes, when there are others than before and they differ in size.
    void fit_cells(std::span<const Proxy> moving) {
        if (!fits_cells_ || fitted_for_ == moving.size() || moving.empty()) return;
        fitted_for_ = moving.size();
        sizes_.clear();
        reserve_for(sizes_, moving.size());
        for (const Proxy& proxy : moving) {
            const Vec2 size = proxy.box.max - proxy.box.min;
            sizes_.push_back(std::max(size.x, size.y));
        }
        const auto median = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 2);
        std::ranges::nth_element(sizes_, median);
        constexpr double wider = 1.25;  // than most boxes: narrower cells list each box in more of them
        constexpr double alike = 1.5;
        const double cell = wider * *median;
        if (cell > alike * cell_ || cell_ > alike * cell) set_cells(cell);
    }

    [[nodiscard]] CellRange cells_under(const Box& box) const {
        // Anything outside, even at infinity, lands in the outermost cell.
        const auto index = [&](double offset, std::uint32_t cells) {
            const double at = std::floor(offset / cell_);
            return at > 0 ? static_cast<std::uint32_t>(std::min(at, cells - 1.0)) : 0;
        };
        return {index(box.min.x - world_.min.x, columns_), index(box.min.y - world_.min.y, rows_),
                index(box.max.x - world_.min.x, columns_), index(box.max.y - world_.min.y, rows_)};
    }
    void each_cell(const CellRange& range, auto&& visit) const {
        for (std::uint32_t row = range.bottom; row <= range.top; ++row)
            for (std::uint32_t column = range.left; column <= range.right; ++column)
                visit(row * columns_ + column);
    }
    /// The first cell that two ranges share, as each_cell() goes.
    [[nodiscard]] std::uint32_t first_shared(const CellRange& a, const CellRange& b) const {
        return std::max(a.bottom, b.bottom) * columns_ + std::max(a.left, b.left);
    }

    void clear_moving() {
        for (const std::uint32_t cell : occupied_) moving_lists_.first[cell] = nobody;
        occupied_.clear();
        moving_lists_.links.clear();
        moving_cells_.clear();
        wide_.clear();
    }

    void insert(Handle proxy) {
        moving_cells_.push_back(cells_under(moving_[proxy].box));
        ++tests_;
        if (moving_cells_.back().count() > most_cells) return wide_.push_back(proxy);
        each_cell(moving_cells_.back(), [&](std::uint32_t cell) {
            if (moving_lists_.first[cell] == nobody) occupied_.push_back(cell);
            moving_lists_.add(cell, proxy);
        });
    }

    void search_cell(std::uint32_t cell, std::vector<Pair>& pairs) {
        most_in_cell_ = std::max(most_in_cell_, count(cell));
        moving_lists_.each(moving_lists_.first[cell], [&](Lists::Link b) {
            const CellRange& under_b = moving_cells_[b.proxy];
            still_lists_.each(still_lists_.first[cell], [&](Lists::Link a) {
                if (first_shared(still_cells_[a.proxy], under_b) == cell) test_still(a.proxy, b.proxy, pairs);
            });
            moving_lists_.each(b.next, [&](Lists::Link a) {
                if (first_shared(moving_cells_[a.proxy], under_b) == cell)
                    test_moving(a.proxy, b.proxy, pairs);
            });
        });
    }

    /// Wide boxes against all; two wide ones once.
    void search_wide(std::vector<Pair>& pairs) {
        for (const Handle a : wide_still_)
            for (Handle b = 0; b < moving_.size(); ++b) test_still(a, b, pairs);
        for (const Handle b : wide_) {
            for (Handle a = 0; a < still_.size(); ++a)
                if (still_cells_[a].count() <= most_cells) test_still(a, b, pairs);
            for (Handle a = 0; a < moving_.size(); ++a)
                if (a < b || moving_cells_[a].count() <= most_cells)
                    if (a != b) test_moving(std::min(a, b), std::max(a, b), pairs);
        }
    }

    void test_still(Handle a, Handle b, std::vector<Pair>& pairs) {
        test(a, still_[a], first_moving_handle() + b, moving_[b], pairs);
    }
    void test_moving(Handle a, Handle b, std::vector<Pair>& pairs) {
        const Handle first = first_moving_handle();
        test(first + a, moving_[a], first + b, moving_[b], pairs);
    }
    [[nodiscard]] Handle first_moving_handle() const { return static_cast<Handle>(still_.size()); }

    /// How many proxies a cell lists.
    [[nodiscard]] int count(std::uint32_t cell) const {
        int n = 0;
        const auto one_more = [&](Lists::Link) { ++n; };
        still_lists_.each(still_lists_.first[cell], one_more);
        moving_lists_.each(moving_lists_.first[cell], one_more);
        return n;
    }

    std::vector<Proxy> still_;
    Box world_;
    bool fits_cells_;
    double cell_ = 0;  ///< width, m
    std::uint32_t columns_ = 1, rows_ = 1;
    std::vector<CellRange> still_cells_;  ///< per still proxy
    Lists still_lists_;
    std::vector<Handle> wide_still_;
    std::size_t fitted_for_ = 0;  ///< so many moving proxies
    std::vector<double> sizes_;   ///< scratch, m

    std::span<const Proxy> moving_;
    std::vector<CellRange> moving_cells_;  ///< per moving proxy
    Lists moving_lists_;
    std::vector<std::uint32_t> occupied_;  ///< cells that list a moving proxy
    std::vector<Handle> wide_;
    int most_in_cell_ = 0;
};

}  // namespace

std::unique_ptr<BroadPhase> make_grid(std::vector<Proxy> still, const Box& world, double cell) {
    return std::make_unique<Grid>(std::move(still), world, cell);
}

}  // namespace flipside::custom
