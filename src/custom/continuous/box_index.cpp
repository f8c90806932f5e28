#include "custom/continuous/box_index.hpp"

#include <cmath>

namespace flipside::custom {

namespace {

/// Limit on the cells along an axis, so that a long and narrow range does not get more cells than boxes.
constexpr std::size_t most_cells = 1024;
/// Limit on the cells that list one box, in units of √n: a wall along the table is listed, a box over the
/// whole table is not.
constexpr double most_touched = 4;

}  // namespace

BoxIndex::Axis BoxIndex::axis(double min, double max, double width, std::size_t most) {
    if (!(max > min) || !(width > 0)) return {min, 0, 1};
    const double cells = std::clamp(std::ceil((max - min) / width), 1.0, static_cast<double>(most));
    return {min, cells / (max - min), static_cast<std::size_t>(cells)};
}

void BoxIndex::each_cell(const Box& box, auto&& visit) const {
    const std::size_t left = x_.cell(box.min.x), right = x_.cell(box.max.x);
    for (std::size_t row = y_.cell(box.min.y), last = y_.cell(box.max.y); row <= last; ++row)
        for (std::size_t column = left; column <= right; ++column) visit(row * x_.cells + column);
}

BoxIndex::BoxIndex(const Box& range, std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    const auto n = static_cast<double>(boxes_.size());
    const Vec2 size = range.max - range.min;
    const double width = std::sqrt(size.x * size.y / std::max(1.0, n));
    const std::size_t most = std::min(most_cells, std::max<std::size_t>(1, boxes_.size()));
    x_ = axis(range.min.x, range.max.x, width, most);
    y_ = axis(range.min.y, range.max.y, width, most);
    const auto each_in_cells = [&](auto&& visit, auto&& is_large) {
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            const Box& box = boxes_[i];
            if (!(box.min.x <= box.max.x && box.min.y <= box.max.y)) continue;
            const auto touched = static_cast<double>((x_.cell(box.max.x) - x_.cell(box.min.x) + 1) *
                                                     (y_.cell(box.max.y) - y_.cell(box.min.y) + 1));
            if (touched > most_touched * std::sqrt(n))
                is_large(i);
            else
                each_cell(box, [&](std::size_t cell) { visit(cell, i); });
        }
    };
    begins_.assign(x_.cells * y_.cells + 1, 0);
    each_in_cells([&](std::size_t cell, std::uint32_t) { ++begins_[cell]; },
                  [&](std::uint32_t i) { large_.push_back(i); });
    std::uint32_t end = 0;
    for (std::uint32_t& begin : begins_) end += begin, begin = end;
    entries_.resize(end);
    each_in_cells([&](std::size_t cell, std::uint32_t i) { entries_[--begins_[cell]] = i; },
                  [](std::uint32_t) {});
}

std::uint64_t BoxIndex::find(const Box& box, std::vector<std::uint32_t>& found) const {
    const auto before = static_cast<std::ptrdiff_t>(found.size());
    std::uint64_t tests = 1;
    const auto test = [&](std::uint32_t i) {
        ++tests;
        if (overlap(box, boxes_[i])) found.push_back(i);
    };
    for (const std::uint32_t i : large_) test(i);
    each_cell(box, [&](std::size_t cell) { std::ranges::for_each(in_cell(cell), test); });
    std::sort(found.begin() + before, found.end());
    found.erase(std::unique(found.begin() + before, found.end()), found.end());
    return tests;
}

std::uint64_t Candidates::cover(const Box& box, const BoxIndex& index) {
    if (fat_.contains(box.min) && fat_.contains(box.max)) return 0;
    const Vec2 size = box.max - box.min;
    // A wider margin makes longer lists, a narrower one more rebuilds; measured on pinball.
    constexpr double margin = 0.25;  // of width plus height
    fat_ = grown(box, margin * (size.x + size.y));
    list_.clear();
    return index.find(fat_, list_);
}

}  // namespace flipside::custom
