#include "custom/broad_phase/hierarchical_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

namespace {

/// To test up to so many boxes one by one is cheaper than to find their cells.
constexpr std::size_t few = 16;
constexpr Box nowhere{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

std::int64_t cell_at(double place, double width) {
    constexpr double far = 0x1p62;
    return static_cast<std::int64_t>(std::clamp(std::floor(place / width), -far, far));
}

}  // namespace

void HierarchicalGrid::reserve(std::size_t boxes) {
    make_room(entries_, boxes);
    heads_.reserve(2 * std::bit_ceil(boxes));
    levels_.reserve(64);
}

void HierarchicalGrid::reset(std::size_t count) {
    entries_.assign(count, {nowhere, {}, none, none, false});
    levels_.clear();
    heads_.assign(count <= few ? 0 : 2 * std::bit_ceil(count), none);
}

void HierarchicalGrid::place(Index i, const Box& box) {
    Entry& entry = entries_[i];
    entry.box = box;
    if (heads_.empty()) return;
    const Cell cell = cell_of(box);
    if (entry.listed && entry.cell == cell) return;
    if (entry.listed) unlink(i);
    entry.cell = cell;
    link(i);
}

void HierarchicalGrid::shrink(std::size_t count) {
    for (auto i = static_cast<Index>(count); i < size(); ++i)
        if (entries_[i].listed) unlink(i);
    entries_.resize(count);
}

HierarchicalGrid::Cell HierarchicalGrid::cell_of(const Box& box) {
    const Vec2 size = box.max - box.min, middle = 0.5 * (box.min + box.max);
    // A little more than the size, so that rounding of the middle cannot take the box out of reach.
    int exponent = 0;
    std::frexp(1.0625 * std::max(size.x, size.y), &exponent);
    const double width = std::ldexp(1, exponent);
    return {exponent, cell_at(middle.x, width), cell_at(middle.y, width)};
}

HierarchicalGrid::Range HierarchicalGrid::cells_near(const Box& box, int exponent) {
    const double width = std::ldexp(1, exponent);
    const Box reach = grown(box, width / 2);
    return {{exponent, cell_at(reach.min.x, width), cell_at(reach.min.y, width)},
            {exponent, cell_at(reach.max.x, width), cell_at(reach.max.y, width)}};
}

double HierarchicalGrid::Range::cells() const {
    return (static_cast<double>(last.column) - static_cast<double>(first.column) + 1) *
           (static_cast<double>(last.row) - static_cast<double>(first.row) + 1);
}

std::size_t HierarchicalGrid::bucket(const Cell& cell) const {
    // Multiplicative hashing: Knuth, "The Art of Computer Programming", vol. 3, 6.4.
    std::uint64_t hash = static_cast<std::uint64_t>(cell.column) * 0x9e3779b97f4a7c15;
    hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(cell.row)) * 0x9e3779b97f4a7c15;
    hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(cell.exponent)) * 0x9e3779b97f4a7c15;
    return (hash >> 32) & (heads_.size() - 1);
}

void HierarchicalGrid::link(Index i) {
    Entry& entry = entries_[i];
    Index& head = heads_[bucket(entry.cell)];
    entry.next = head;
    entry.previous = none;
    entry.listed = true;
    if (head != none) entries_[head].previous = i;
    head = i;
    count(entry.cell.exponent, 1);
}

void HierarchicalGrid::unlink(Index i) {
    const Entry& entry = entries_[i];
    if (entry.previous != none)
        entries_[entry.previous].next = entry.next;
    else
        heads_[bucket(entry.cell)] = entry.next;
    if (entry.next != none) entries_[entry.next].previous = entry.previous;
    count(entry.cell.exponent, -1);
}

void HierarchicalGrid::count(int exponent, int change) {
    auto level = std::ranges::find(levels_, exponent, &Level::exponent);
    if (level == levels_.end()) level = levels_.insert(level, {exponent, 0});
    level->boxes += static_cast<std::size_t>(change);
    if (level->boxes == 0) levels_.erase(level);
}

std::uint64_t HierarchicalGrid::each_overlap(const Box& box, auto&& visit) const {
    std::uint64_t tests = 0;
    const auto test = [&](Index i) {
        ++tests;
        if (overlap(box, entries_[i].box)) visit(i);
    };
    double cells = 0;
    for (const Level& level : levels_) cells += cells_near(box, level.exponent).cells();
    if (heads_.empty() || cells >= static_cast<double>(size())) {
        for (Index i = 0; i < size(); ++i) test(i);
        return tests;
    }
    for (const Level& level : levels_) {
        const auto [first, last] = cells_near(box, level.exponent);
        for (Cell cell = first; cell.row <= last.row; ++cell.row)
            for (cell.column = first.column; cell.column <= last.column; ++cell.column)
                for (Index i = heads_[bucket(cell)]; i != none; i = entries_[i].next)
                    if (entries_[i].cell == cell) test(i);
    }
    return tests;
}

std::uint64_t HierarchicalGrid::find(const Box& box, std::vector<Index>& found) const {
    found.clear();
    const std::uint64_t tests = each_overlap(box, [&](Index i) { found.push_back(i); });
    std::ranges::sort(found);
    return tests;
}

bool HierarchicalGrid::any(const Box& box, Index except) const {
    bool found = false;
    each_overlap(box, [&](Index i) { found = found || i != except; });
    return found;
}

}  // namespace flipside::custom
