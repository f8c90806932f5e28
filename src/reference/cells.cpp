#include "reference/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipside::reference {

void Cells::build(const Box& area, const std::vector<Item>& items, std::size_t balls, double radius) {
    constexpr double cells_per_item = 4, most_cells = 40'000;
    area_ = area;
    radius_ = radius;
    const double w = std::max(area.max.x - area.min.x, 1e-9), h = std::max(area.max.y - area.min.y, 1e-9);
    const double wanted =
        std::min(most_cells, cells_per_item * static_cast<double>(items.size() + balls + 1));
    // A little wider than the largest ball, so that rounding at a border cannot hide a neighbour.
    width_ = std::max({2.001 * radius, std::sqrt(w * h / wanted), w / 1000, h / 1000});
    columns_ = static_cast<Index>(std::max(1.0, std::floor(w / width_)));
    rows_ = static_cast<Index>(std::max(1.0, std::floor(h / width_)));
    features_.assign(count(), {});
    sensors_.assign(count(), {});
    first_.assign(count(), none);
    next_.assign(balls, none);
    previous_.assign(balls, none);
    const double reach = radius * 1.001 + 1e-9;
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        const Item& item = items[i];
        const Index left = column(item.box.min.x - reach), right = column(item.box.max.x + reach);
        const Index low = row(item.box.min.y - reach), high = row(item.box.max.y + reach);
        for (Index y = low; y <= high; ++y)
            for (Index x = left; x <= right; ++x) {
                if (item.is_sensor)
                    sensors_[y * columns_ + x].push_back(item.part);
                else
                    features_[y * columns_ + x].push_back(i);
            }
    }
}

Cells::Index Cells::column(double x) const {
    const double at = std::floor((x - area_.min.x) / width_);
    return static_cast<Index>(std::clamp(at, 0.0, static_cast<double>(columns_) - 1));
}

Cells::Index Cells::row(double y) const {
    const double at = std::floor((y - area_.min.y) / width_);
    return static_cast<Index>(std::clamp(at, 0.0, static_cast<double>(rows_) - 1));
}

Cells::Index Cells::at(Vec2 position) const {
    return row(position.y) * columns_ + column(position.x);
}

Box Cells::box(Index cell) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    const Index x = cell % columns_, y = cell / columns_;
    return {{x == 0 ? -far : area_.min.x + x * width_, y == 0 ? -far : area_.min.y + y * width_},
            {x + 1 == columns_ ? far : area_.min.x + (x + 1) * width_,
             y + 1 == rows_ ? far : area_.min.y + (y + 1) * width_}};
}

Cells::Index Cells::beyond(Index cell, int side) const {
    if (side == 0) return cell - 1;
    if (side == 1) return cell + 1;
    return side == 2 ? cell - columns_ : cell + columns_;
}

void Cells::link(std::uint32_t ball, Index cell) {
    if (next_.size() <= ball) {
        next_.resize(ball + 1, none);
        previous_.resize(ball + 1, none);
    }
    const std::int32_t after = first_[cell];
    next_[ball] = after;
    previous_[ball] = none;
    if (after != none) previous_[static_cast<std::size_t>(after)] = static_cast<std::int32_t>(ball);
    first_[cell] = static_cast<std::int32_t>(ball);
}

void Cells::unlink(std::uint32_t ball, Index cell) {
    const std::int32_t before = previous_[ball], after = next_[ball];
    if (before != none)
        next_[static_cast<std::size_t>(before)] = after;
    else
        first_[cell] = after;
    if (after != none) previous_[static_cast<std::size_t>(after)] = before;
}

int Cells::balls(Index cell) const {
    int count = 0;
    for (std::int32_t b = first_[cell]; b != none; b = next_[static_cast<std::size_t>(b)]) ++count;
    return count;
}

}  // namespace flipside::reference
