// Uniform grid of square cells. A proxy is listed in every cell that its box overlaps. Still proxies are
// listed once; moving ones are listed again for every search. Pairs are searched only in cells that list a
// moving proxy. A box over more than `most_cells_listed` cells is wide: it is in no list and is tested
// against all others.
//
// Finding the cells under a box needs its four coordinates once, and counts as one box test.
// Cost: O(n · cells per box + pairs sharing a cell); wide boxes cost O(n) each.
// Bentley, Friedman 1979, "Data structures for range searching", 2.3; Ericson 2005, "Real-time collision
// detection", 7.1.

#include <algorithm>
#include <cmath>

#include "custom/broad_phase/capacity.hpp"
#include "custom/broad_phase/cell_lists.hpp"

namespace flipside::custom {

namespace {

class Grid final : public CellBroadPhase {
  public:
    Grid(std::vector<Proxy> still, const BroadPhaseOptions& options)
        : CellBroadPhase(std::move(still)), world_(options.world), fits_cells_(options.grid_cell == 0) {
        const Vec2 size = world_.max - world_.min;
        set_cells(fits_cells_ ? std::max(size.x, size.y) : widened(options.grid_cell, most_cells));
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        return {.name = "grid",
                .leaves = static_cast<int>(columns_ * rows_),
                .leaf_width = cell_,
                .leaf_height = cell_,
                .most_in_leaf = most_in_cell_};
    }

    void inspect(Inspector& inspector) const override {
        if (fits_cells_ && fitted_for_ == 0) return;  // not fitted yet
        for (std::uint32_t row = 0; row < rows_; ++row)
            for (std::uint32_t column = 0; column < columns_; ++column) {
                const Vec2 corner =
                    world_.min + cell_ * Vec2{static_cast<double>(column), static_cast<double>(row)};
                inspector.cell({corner, corner + Vec2{cell_, cell_}}, count(row * columns_ + column));
            }
    }

  private:
    static constexpr double most_cells = 0x1p22;
    static constexpr double most_cells_per_box = 1024;      ///< of fitted cells
    static constexpr std::uint64_t most_cells_listed = 64;  ///< under a box that is listed

    void search() override {
        clear_moving();
        fit_cells();
        reserve_for(moving_lists_.links, moving_.size(), pairs_per_ball);
        reserve_for(occupied_, moving_.size(), pairs_per_ball);
        reserve_for(moving_cells_, moving_.size());
        reserve_for(wide_, moving_.size());
        for (Handle i = 0; i < moving_.size(); ++i) insert(i);
        most_in_cell_ = 0;
        for (const std::uint32_t cell : occupied_) search_cell(cell, cell % columns_, cell / columns_);
        search_wide();
    }

    /// A width of cells, m, at least `cell`, of which the world has at most so many.
    [[nodiscard]] double widened(double cell, double most) const {
        const Vec2 size = world_.max - world_.min;
        return std::max({cell, std::sqrt(size.x * size.y / most), std::max(size.x, size.y) * 0x1p-16});
    }

    /// Sets the width of the cells and lists the still proxies in them.
    void set_cells(double cell) {
        const Vec2 size = world_.max - world_.min;
        cell_ = cell;
        const auto cells_along = [&](double length) {
            return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / cell_)));
        };
        columns_ = cells_along(size.x), rows_ = cells_along(size.y);
        for (CellLists* lists : {&still_lists_, &moving_lists_}) lists->reset(columns_ * rows_);
        still_cells_.clear();
        wide_still_.clear();
        for (Handle i = 0; i < still_.size(); ++i) {
            still_cells_.push_back(cells_under(still_[i].box));
            if (still_cells_.back().count() > most_cells_listed)
                wide_still_.push_back(i);
            else
                still_cells_.back().each([&](std::uint32_t column, std::uint32_t row) {
                    still_lists_.add(row * columns_ + column, i);
                });
        }
    }

    /// Fits the cells to the median size of the boxes, if their number has changed and the size differs. Few
    /// boxes in a large world get wider cells, since making each cell costs time and memory.
    void fit_cells() {
        if (!fits_cells_ || fitted_for_ == moving_.size() || moving_.empty()) return;
        fitted_for_ = moving_.size();
        sizes_.clear();
        reserve_for(sizes_, moving_.size());
        for (const Proxy& proxy : moving_) {
            const Vec2 size = proxy.box.max - proxy.box.min;
            sizes_.push_back(std::max(size.x, size.y));
        }
        const auto median = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 2);
        std::ranges::nth_element(sizes_, median);
        constexpr double wider = 1.25;  // than the median box; narrower cells list each box more often
        constexpr double alike = 1.5;
        const double most = std::min(most_cells, most_cells_per_box * static_cast<double>(moving_.size()));
        const double cell = widened(wider * *median, most);
        if (cell > alike * cell_ || cell_ > alike * cell) set_cells(cell);
    }

    [[nodiscard]] CellRange cells_under(const Box& box) const {
        return {cell_index(box.min.x - world_.min.x, cell_, columns_),
                cell_index(box.min.y - world_.min.y, cell_, rows_),
                cell_index(box.max.x - world_.min.x, cell_, columns_),
                cell_index(box.max.y - world_.min.y, cell_, rows_)};
    }

    void clear_moving() {
        for (const std::uint32_t cell : occupied_) moving_lists_.first[cell] = CellLists::none;
        occupied_.clear();
        moving_lists_.links.clear();
        moving_cells_.clear();
        wide_.clear();
    }

    void insert(Handle proxy) {
        const CellRange range = cells_under(moving_[proxy].box);
        moving_cells_.push_back(range);
        ++tests_;
        if (range.count() > most_cells_listed) return wide_.push_back(proxy);
        range.each([&](std::uint32_t column, std::uint32_t row) {
            const std::uint32_t cell = row * columns_ + column;
            if (moving_lists_.first[cell] == CellLists::none) occupied_.push_back(cell);
            moving_lists_.add(cell, proxy);
        });
    }

    /// Tests wide boxes against all others; each pair of two wide ones once.
    void search_wide() {
        for (const Handle a : wide_still_)
            for (Handle b = 0; b < moving_.size(); ++b) test_still(a, b);
        for (const Handle b : wide_) {
            for (Handle a = 0; a < still_.size(); ++a)
                if (still_cells_[a].count() <= most_cells_listed) test_still(a, b);
            for (Handle a = 0; a < moving_.size(); ++a)
                if (a != b && (a < b || moving_cells_[a].count() <= most_cells_listed)) test_moving(a, b);
        }
    }

    Box world_;
    bool fits_cells_;
    double cell_ = 0;  ///< width, m
    std::uint32_t columns_ = 1, rows_ = 1;
    std::vector<Handle> wide_still_;
    std::size_t fitted_for_ = 0;  ///< number of moving proxies
    std::vector<double> sizes_;   ///< m, buffer of fit_cells()

    std::vector<std::uint32_t> occupied_;  ///< cells that list a moving proxy
    std::vector<Handle> wide_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_grid(std::vector<Proxy> still, const BroadPhaseOptions& options) {
    return std::make_unique<Grid>(std::move(still), options);
}

}  // namespace flipside::custom
