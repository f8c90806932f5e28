#pragma once
/// The broad phase: a grid whose cells list the features and sensors that balls in them can touch, and the
/// balls whose centres they contain. A cell is at least as wide as the largest ball, so a ball can only touch
/// features of its own cell, and balls of its own and the eight adjacent cells. A ball changes its cell by an
/// event (Rapaport 1980, "The event scheduling problem in molecular dynamic simulation"). Cells at the border
/// extend to infinity.

#include <cstdint>
#include <vector>

#include "world/scene.hpp"

namespace flipside::reference {

class Cells {
  public:
    using Index = std::uint32_t;
    static constexpr std::int32_t none = -1;

    /// A feature, sensor or gate with the box of all its poses.
    struct Item {
        Box box;
        PartIndex part = 0;
        bool is_sensor =
            false;  ///< a sensor or gate, listed by its part; else a feature, listed by its index
    };
    /// For balls of up to `radius`. `items` holds the features first, in order.
    void build(const Box& area, const std::vector<Item>& items, std::size_t balls, double radius);

    [[nodiscard]] double largest() const { return radius_; }
    [[nodiscard]] Index at(Vec2 position) const;
    [[nodiscard]] Box box(Index cell) const;
    /// The cell beyond a side: 0 left, 1 right, 2 down, 3 up.
    [[nodiscard]] Index beyond(Index cell, int side) const;
    [[nodiscard]] const std::vector<std::uint32_t>& features(Index cell) const { return features_[cell]; }
    [[nodiscard]] const std::vector<PartIndex>& sensors(Index cell) const { return sensors_[cell]; }

    void link(std::uint32_t ball, Index cell);
    void unlink(std::uint32_t ball, Index cell);
    [[nodiscard]] int balls(Index cell) const;
    /// Calls visit(ball) for every ball in the cell and around it.
    void each_near(Index cell, auto&& visit) const {
        const auto column = static_cast<int>(cell % columns_), row = static_cast<int>(cell / columns_);
        const auto last_column = static_cast<int>(columns_) - 1, last_row = static_cast<int>(rows_) - 1;
        for (int y = row > 0 ? row - 1 : 0; y <= row + 1 && y <= last_row; ++y)
            for (int x = column > 0 ? column - 1 : 0; x <= column + 1 && x <= last_column; ++x) {
                const auto near = static_cast<Index>(y) * columns_ + static_cast<Index>(x);
                for (std::int32_t b = first_[near]; b != none; b = next_[static_cast<std::size_t>(b)])
                    visit(static_cast<std::uint32_t>(b));
            }
    }
    [[nodiscard]] Index count() const { return columns_ * rows_; }

  private:
    [[nodiscard]] Index column(double x) const;
    [[nodiscard]] Index row(double y) const;

    Box area_;
    double radius_ = 0, width_ = 1;
    Index columns_ = 1, rows_ = 1;
    std::vector<std::vector<std::uint32_t>> features_;
    std::vector<std::vector<PartIndex>> sensors_;
    std::vector<std::int32_t> first_;            ///< first ball of each cell
    std::vector<std::int32_t> next_, previous_;  ///< per ball
};

}  // namespace flipside::reference
