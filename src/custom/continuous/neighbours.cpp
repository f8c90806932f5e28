#include "custom/continuous/neighbours.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "custom/broad_phase/capacity.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom {

namespace {

/// Least width of a cell, in diameters of a ball: with cell_slack on both sides, balls two cells apart cannot
/// touch. A gap below sleep_distance is overlooked where both balls are at the very end of their slack.
constexpr double least_width = 1.25;
/// How far the centre of a ball may be outside its cell, in widths.
constexpr double cell_slack = 0.1;
static_assert(least_width * (1 - 2 * cell_slack) >= 1);

/// Margin within which a cell of a BoxIndex lists boxes, and within which it is asked for them, in widths.
/// The difference exceeds all rounding. A ball reaches beyond its cell by cell_slack and by its radius.
constexpr double listed_margin = 0.55, asked_margin = 0.54;
static_assert(asked_margin >= cell_slack + 0.5 / least_width * (1 + sleep_distance));
/// Limit on the cells of a level, and on their entries: the first, and so many more per box.
constexpr double least_limit = 65536, most_per_box = 64;

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

std::uint32_t Cells::level_for(double width) const {
    const auto level = std::ranges::lower_bound(widths_, width) - widths_.begin();
    return std::min(static_cast<std::uint32_t>(level), most_levels - 1);
}

void Cells::insert(BallIndex i, std::uint32_t level, Vec2 center) {
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
    const auto rounded = static_cast<float>(std::min<double>(least, std::numeric_limits<float>::max()));
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

BoxIndex::BoxIndex(const Box& range, double width, std::vector<Box> boxes)
    : range_(range), boxes_(std::move(boxes)) {
    const Vec2 size = range.max - range.min;
    const double most = least_limit + most_per_box * static_cast<double>(boxes_.size());
    for (bool last = false; !last; width *= 2) {
        last = width >= std::max(size.x, size.y);
        Level level;
        level.width = width;
        level.per_width = 1 / width;
        if (fill(level, last ? INFINITY : most)) levels_.push_back(std::move(level));
    }
}

/// Moves what is outside the range onto its border, so that what overlaps still does.
Box BoxIndex::clamped(const Box& box) const {
    const auto inside = [&](Vec2 p) {
        return Vec2{std::min(std::max(p.x, range_.min.x), range_.max.x),
                    std::min(std::max(p.y, range_.min.y), range_.max.y)};
    };
    return {inside(box.min), inside(box.max)};
}

bool BoxIndex::fill(Level& level, double most) const {
    const auto first = [&](double at) { return std::floor(at * level.per_width); };
    const Vec2 begin{first(range_.min.x), first(range_.min.y)};
    const double columns = first(range_.max.x) - begin.x + 1, rows = first(range_.max.y) - begin.y + 1;
    if (columns * rows > most) return false;
    level.low = level.width * begin;
    level.columns = static_cast<std::uint32_t>(columns);
    level.rows = static_cast<std::uint32_t>(rows);
    std::vector<CellRange> ranges;  // per box
    double entries = 0;
    for (const Box& box : boxes_) {
        const Box wide = grown(clamped(box), listed_margin * level.width);
        const Vec2 from = level.per_width * (wide.min - level.low);
        const Vec2 to = level.per_width * (wide.max - level.low);
        ranges.push_back({cell_index(from.x, level.columns), cell_index(from.y, level.rows),
                          cell_index(to.x, level.columns), cell_index(to.y, level.rows)});
        entries += static_cast<double>(ranges.back().count());
    }
    if (entries > most) return false;
    // Counts the entries of each cell, finds where they end, and fills them in from there, the last box
    // first.
    level.begins.assign(level.cell(0, level.rows) + 1, 0);
    for (const CellRange& range : ranges)
        range.each([&](auto column, auto row) { ++level.begins[level.cell(column, row)]; });
    std::partial_sum(level.begins.begin(), level.begins.end(), level.begins.begin());
    level.entries.resize(level.begins.back());
    for (auto i = static_cast<std::uint32_t>(ranges.size()); i-- > 0;)
        ranges[i].each(
            [&](auto column, auto row) { level.entries[--level.begins[level.cell(column, row)]] = i; });
    return true;
}

std::span<const std::uint32_t> BoxIndex::near(const Box& box) const {
    const Box inside = clamped(box);
    const Vec2 center = 0.5 * (inside.min + inside.max), half = 0.5 * (inside.max - inside.min);
    for (auto level = levels_.begin();; ++level) {
        const Vec2 at = level->per_width * (center - level->low), reach = level->per_width * half;
        const std::uint32_t column = cell_index(at.x, level->columns), row = cell_index(at.y, level->rows);
        const double beyond =
            std::max(std::abs(at.x - column - 0.5) + reach.x, std::abs(at.y - row - 0.5) + reach.y) - 0.5;
        if (beyond > asked_margin && level + 1 != levels_.end()) continue;
        const std::uint32_t* begin = &level->begins[level->cell(column, row)];
        return std::span(level->entries).subspan(begin[0], begin[1] - begin[0]);
    }
}

}  // namespace flipside::custom
