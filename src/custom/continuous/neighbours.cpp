#include "custom/continuous/neighbours.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "custom/broad_phase/capacity.hpp"

namespace flipside::custom {

namespace {

/// Least width of a cell, in diameters of a ball: with `slack` on both sides, balls two cells apart cannot
/// touch.
constexpr double least_width = 1.25;
/// How far the centre of a ball may be outside its cell, in widths.
constexpr double cell_slack = 0.1;
static_assert(least_width * (1 - 2 * cell_slack) >= 1);

/// Limit on the cells along an axis, so that a long and narrow range does not get more cells than boxes.
constexpr std::size_t most_cells = 1024;
/// Limit on the cells that list one box, in units of √n: a wall along the table is listed, a box over the
/// whole table is not.
constexpr double most_touched = 4;

}  // namespace

double Cells::width_for(double radius) {
    return 2 * least_width * radius;
}

std::int64_t Cells::index_at(double coordinate, double width) {
    constexpr double far = 0x1p52;
    return static_cast<std::int64_t>(std::clamp(std::floor(coordinate / width), -far, far));
}

void Cells::reserve(std::size_t balls) {
    reserve_for(links_, balls);
    reserve_for(cells_, balls);
    heads_.reserve(4 * std::bit_ceil(balls));
    levels_.reserve(most_levels);
}

void Cells::reset(std::span<const Ball> balls) {
    links_.assign(balls.size(), {});
    cells_.assign(balls.size(), {});
    levels_.clear();
    heads_.assign(4 * std::bit_ceil(balls.size()), none);
    mask_ = heads_.size() - 1;
    if (balls.empty()) return;
    double width = width_for(std::ranges::min(balls, {}, &Ball::radius).radius);
    for (double& w : widths_) w = width, width *= 2;
}

void Cells::choose_level(BallIndex i, double width) {
    int level = 0;
    std::frexp(width / widths_[0], &level);
    if (width <= widths_[0]) level = 0;
    level = std::min<int>(level, most_levels - 1);
    if (cells_[i].level == static_cast<std::uint32_t>(level)) return;
    remove(i);
    cells_[i].level = static_cast<std::uint32_t>(level);
}

void Cells::insert(BallIndex i, Vec2 center) {
    const std::uint32_t level = cells_[i].level;
    const Cell cell{level, index_at(center.x, widths_[level]), index_at(center.y, widths_[level])};
    Link& link = links_[i];
    if (link.key != unlisted && cell == cells_[i]) return;
    remove(i);
    cells_[i] = cell;
    link.key = key_of(cell);
    BallIndex& head = heads_[bucket(cell)];
    link.next = head;
    link.previous = none;
    if (head != none) links_[head].previous = i;
    head = i;
    count(level, 1);
}

void Cells::remove(BallIndex i) {
    Link& link = links_[i];
    if (link.key == unlisted) return;
    link.key = unlisted;
    if (link.previous != none)
        links_[link.previous].next = link.next;
    else
        heads_[bucket(cells_[i])] = link.next;
    if (link.next != none) links_[link.next].previous = link.previous;
    count(cells_[i].level, -1);
}

void Cells::count(std::uint32_t number, int change) {
    auto level = std::ranges::find(levels_, number, &Level::number);
    if (level == levels_.end()) level = levels_.insert(level, {number, 0});
    level->balls += static_cast<std::size_t>(change);
    if (level->balls == 0) levels_.erase(level);
}

double Cells::time_in_cell(BallIndex i, Vec2 center, Vec2 velocity, Vec2 top) const {
    const double w = widths_[cells_[i].level], slack = cell_slack * w;
    const auto along = [&](double at, std::int64_t index, double speed, double bend) {
        const double low = at - (static_cast<double>(index) * w - slack);
        const double ahead = speed > 0 ? w + 2 * slack - low : low;
        const double behind = speed > 0 ? low : w + 2 * slack - low;
        if (!(ahead > 0 && behind > 0)) return 0.0;
        speed = std::abs(speed);
        if (bend <= 0) return speed > 0 ? ahead / speed : INFINITY;
        const double forward = 2 * ahead / (speed + std::sqrt(speed * speed + 2 * bend * ahead));
        const double back = (speed + std::sqrt(speed * speed + 2 * bend * behind)) / bend;
        return std::min(forward, back);
    };
    const double least = std::min(along(center.x, cells_[i].column, velocity.x, top.x),
                                  along(center.y, cells_[i].row, velocity.y, top.y));
    // Single precision keeps the position of the cells out of the last bits of later results.
    const auto rounded = static_cast<float>(least);
    return rounded > least ? std::nextafter(rounded, 0.0F) : rounded;
}

void Cells::inspect(Inspector& inspector) const {
    std::vector<Cell> used;
    for (BallIndex i = 0; i < cells_.size(); ++i)
        if (links_[i].key != unlisted) used.push_back(cells_[i]);
    std::ranges::sort(used);
    for (auto first = used.begin(); first != used.end();) {
        const auto last = std::find_if(first, used.end(), [&](const Cell& cell) { return cell != *first; });
        const double width = widths_[first->level];
        const Vec2 corner{width * static_cast<double>(first->column),
                          width * static_cast<double>(first->row)};
        inspector.cell({corner, corner + Vec2{width, width}}, static_cast<int>(last - first));
        first = last;
    }
}

BoxIndex::Axis BoxIndex::axis(double min, double max, double width, std::size_t most) {
    if (!(max > min) || !(width > 0)) return {min, 0, 1};
    const double cells = std::clamp(std::ceil((max - min) / width), 1.0, static_cast<double>(most));
    return {min, cells / (max - min), static_cast<std::uint32_t>(cells)};
}

BoxIndex::BoxIndex(const Box& range, std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    const auto n = static_cast<double>(boxes_.size());
    const Vec2 size = range.max - range.min;
    constexpr double boxes_per_cell = 2;  // 1 and 4 take 5 % longer on pinball
    const double width = std::sqrt(boxes_per_cell * size.x * size.y / std::max(1.0, n));
    const std::size_t most = std::min(most_cells, std::max<std::size_t>(1, boxes_.size()));
    x_ = axis(range.min.x, range.max.x, width, most);
    y_ = axis(range.min.y, range.max.y, width, most);
    const auto each_in_cells = [&](auto&& visit, auto&& is_large) {
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            const Box& box = boxes_[i];
            if (!(box.min.x <= box.max.x && box.min.y <= box.max.y)) continue;
            const CellRange cells = cells_of(box);
            if (static_cast<double>(cells.count()) > most_touched * std::sqrt(n))
                is_large(i);
            else
                cells.each([&](std::uint32_t column, std::uint32_t row) {
                    visit(cell_at(column, row), Entry{i, column, cells.left, cells.low});
                });
        }
    };
    begins_.assign(std::size_t{x_.cells} * y_.cells + 1, 0);
    each_in_cells([&](std::size_t cell, const Entry&) { ++begins_[cell]; },
                  [&](std::uint32_t i) { large_.push_back(i); });
    std::uint32_t end = 0;
    for (std::uint32_t& begin : begins_) end += begin, begin = end;
    entries_.resize(end);
    each_in_cells([&](std::size_t cell, const Entry& entry) { entries_[--begins_[cell]] = entry; },
                  [](std::uint32_t) {});
}

std::uint64_t BoxIndex::find(const Box& box, std::vector<std::uint32_t>& found) const {
    const std::size_t before = found.size();
    const CellRange cells = cells_of(box);
    std::size_t most = large_.size();
    for (std::uint32_t row = cells.low; row <= cells.high; ++row) most += in_row(cells, row).size();
    found.resize(before + std::min(most, size() + 1));
    // Every box is written, and stays if it overlaps: branches would be mispredicted.
    std::size_t end = before, tests = 1;
    const auto test = [&](std::uint32_t i, bool wanted) {
        found[end] = i;
        end += static_cast<std::size_t>(wanted & overlap(box, boxes_[i]));
        tests += static_cast<std::size_t>(wanted);
    };
    for (const std::uint32_t i : large_) test(i, true);
    for (std::uint32_t row = cells.low; row <= cells.high; ++row)
        for (const Entry& entry : in_row(cells, row)) {
            // A box in several of these cells counts in the first.
            const bool first_column = entry.column == std::max(entry.left, cells.left);
            test(entry.index, first_column & (row == std::max(entry.low, cells.low)));
        }
    found.resize(end);
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
    return tests;
}

std::span<const std::uint32_t> Candidates::near(const Box& box, Vec2 velocity, const BoxIndex& index,
                                                std::vector<std::uint32_t>& found, std::uint64_t& tests) {
    if (fat_.contains(box.min) && fat_.contains(box.max)) return list();
    const Vec2 size = box.max - box.min;
    // A wider box makes longer lists, a narrower one more rebuilds; measured on pinball.
    constexpr double margin = 0.1;  // of width plus height
    constexpr double ahead = 0.05;  // s
    fat_ = grown(box, margin * (size.x + size.y));
    const Vec2 shift = ahead * velocity;
    fat_ = united(fat_, {fat_.min + shift, fat_.max + shift});
    found.clear();
    tests += index.find(fat_, found);
    count_ = static_cast<std::uint32_t>(found.size());
    if (count_ > most_short)
        long_list_ = found;
    else
        std::ranges::copy(found, short_list_.begin());
    return list();
}

}  // namespace flipside::custom
