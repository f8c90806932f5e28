// Uniform grid of square cells. A proxy is listed in the cells under it (quadtree.hpp). But a box over more
// than `most_cells_listed` cells is wide: it is in no list and is tested against all others.
//
// Cost: O(n · cells per box + pairs sharing a cell); wide boxes cost O(n) each.
// Bentley, Friedman 1979, "Data structures for range searching", 2.3; Ericson 2005, "Real-time collision
// detection", 7.1.

#include "custom/broad_phase/quadtree.hpp"

namespace flipside::custom {

namespace {

class Grid final : public CellBroadPhase {
  public:
    Grid(std::vector<Proxy> still, const BroadPhaseOptions& options)
        : CellBroadPhase(std::move(still), options.world), fits_cells_(options.grid_cell == 0) {
        divide(fits_cells_ ? std::max(extent_.x, extent_.y) : widened(options.grid_cell, most_cells));
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        return {.name = "grid",
                .leaves = static_cast<int>(columns_ * rows_),
                .leaf_width = size_.x,
                .leaf_height = size_.y,
                .most_in_leaf = most_in_cell_};
    }

    [[nodiscard]] std::vector<Cell> cells() const override {
        std::vector<Cell> cells;
        if (fits_cells_ && fitted_for_ == 0) return cells;  // not fitted yet
        CellRange{0, 0, columns_ - 1, rows_ - 1}.each([&](std::uint32_t column, std::uint32_t row) {
            const Vec2 corner =
                world_.min + size_.x * Vec2{static_cast<double>(column), static_cast<double>(row)};
            const int listed = count(row * columns_ + column);
            cells.push_back({{corner, corner + size_}, listed, listed});
        });
        return cells;
    }

  private:
    static constexpr double most_cells = 0x1p22;
    static constexpr double most_cells_per_box = 1024;      ///< of fitted cells
    static constexpr std::uint64_t most_cells_listed = 64;  ///< under a box that is listed

    void insert(Handle b, const CellRange& range) override {
        const bool wide = range.count() > most_cells_listed, moves = b >= first_moving_;
        if (wide && moves)
            for (Handle a = 0; a < b; ++a) test(a, b);
        if (!wide && moves)
            for (const Handle a : wide_) test(a, b);
        if (wide) return wide_.push_back(b);
        range.each(
            [&](std::uint32_t column, std::uint32_t row) { list(b, row * columns_ + column, column, row); });
    }

    /// A width of cells, m, at least `cell`, of which the world has at most so many.
    [[nodiscard]] double widened(double cell, double most) const {
        return std::max(
            {cell, std::sqrt(extent_.x * extent_.y / most), std::max(extent_.x, extent_.y) * 0x1p-16});
    }

    /// Divides the world into cells of this width.
    void divide(double cell) {
        const auto cells_along = [&](double length) {
            return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / cell)));
        };
        wide_.clear();
        set_cells({cell, cell}, cells_along(extent_.x), cells_along(extent_.y));
    }

    /// Fits the cells to the median size of the boxes, if their number has changed and the size differs. Few
    /// boxes in a large world get wider cells, since making each cell costs time and memory.
    void fit_cells() override {
        while (!wide_.empty() && wide_.back() >= first_moving_) wide_.pop_back();
        reserve_for(wide_, proxies_.size());
        if (!fits_cells_ || fitted_for_ == moving() || moving() == 0) return;
        fitted_for_ = moving();
        sizes_.clear();
        reserve_for(sizes_, moving());
        for (const Proxy& proxy : std::span(proxies_).subspan(first_moving_)) {
            const Vec2 size = proxy.box.max - proxy.box.min;
            sizes_.push_back(std::max(size.x, size.y));
        }
        const auto median = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 2);
        std::ranges::nth_element(sizes_, median);
        constexpr double wider = 1.25;  // than the median box; narrower cells list each box more often
        constexpr double alike = 1.5;
        const double most = std::min(most_cells, most_cells_per_box * static_cast<double>(moving()));
        const double cell = widened(wider * *median, most);
        if (cell > alike * size_.x || size_.x > alike * cell) divide(cell);
    }

    const Vec2 extent_ = world_.max - world_.min;  ///< m
    bool fits_cells_;
    std::size_t fitted_for_ = 0;  ///< number of moving proxies
    std::vector<double> sizes_;   ///< m, buffer of fit_cells()
    std::vector<Handle> wide_;    ///< those still come first
};

}  // namespace

std::unique_ptr<BroadPhase> make_grid(std::vector<Proxy> still, const BroadPhaseOptions& options) {
    return std::make_unique<Grid>(std::move(still), options);
}

}  // namespace flipside::custom
