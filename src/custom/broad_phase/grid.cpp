// Uniform grid, for many things of like size. A moving proxy that fits into a cell ("small") is listed
// once, in the cell of its middle, by a counting sort that leaves the proxies themselves in order of cells.
// Two small ones that overlap are then in the same or in neighbouring cells, so each looks at the rest of
// its cell with the next one in the row, and at three cells of the row above, so far as it reaches: two
// runs of memory.
//
// What is still or does not fit ("wide") is listed in every cell that it or its margin of half a cell
// overlaps, so a small proxy finds all of them in its one cell. Still proxies are listed once, unless
// an automatic cell must change. Two wide ones may share several cells, and are looked at in the first.
//
// The entry that a pair is looked up in is one cache line, not a structure of arrays: runs are too short
// (a few proxies) for the compiler to gain from the latter.
//
// Finding a proxy's cell takes the four coordinates once, as one box test does, and is counted as one.
// Cost: O(cells + n) for n small proxies of bounded density. Cells number at most 4n + 256 when automatic.
// Counting sort: Knuth 1973, "The Art of Computer Programming" 3, 5.2; grids after Ericson 2005,
// "Real-Time Collision Detection", 7.1.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

#include "custom/broad_phase/pair_order.hpp"
#include "custom/broad_phase/room.hpp"
#include "custom/sift.hpp"

namespace flipside::custom {

namespace {

using Cell = std::uint32_t;

/// Cells under a box, both ends included; rows from the bottom.
struct Cells {
    std::uint32_t left, bottom, right, top;
};

/// How the world is divided.
struct Division {
    Vec2 origin;
    double size = 0;      ///< m, of a cell
    double per_size = 0;  ///< 1/m, its inverse
    std::uint32_t columns = 1, rows = 1;

    [[nodiscard]] std::uint32_t column(double x) const { return place(x - origin.x, columns); }
    [[nodiscard]] std::uint32_t row(double y) const { return place(y - origin.y, rows); }
    [[nodiscard]] Cells under(const Box& box) const {
        return {column(box.min.x), row(box.min.y), column(box.max.x), row(box.max.y)};
    }
    /// The lower left one of a cell.
    [[nodiscard]] Vec2 corner(std::uint32_t column, std::uint32_t row) const {
        return {origin.x + column * size, origin.y + row * size};
    }
    [[nodiscard]] Cell at(std::uint32_t column, std::uint32_t row) const { return row * columns + column; }
    [[nodiscard]] Cell count() const { return columns * rows; }
    void each(const Cells& cells, auto&& visit) const {
        for (std::uint32_t y = cells.bottom; y <= cells.top; ++y)
            for (std::uint32_t x = cells.left; x <= cells.right; ++x) visit(x, y);
    }

  private:
    [[nodiscard]] std::uint32_t place(double offset, std::uint32_t count) const {
        // Written so that anything outside, even at infinity, lands in the outermost cell.
        const double at = offset * per_size;
        return at > 0 ? static_cast<std::uint32_t>(std::min(at, count - 1.0)) : 0;
    }
};

class Grid final : public BroadPhase {
  public:
    Grid(std::span<const Proxy> still, const Box& world, double cell) : world_(world), automatic_(cell == 0) {
        for (const Proxy& proxy : still) {
            still_.push_back({proxy, first_moving(), {}});
            layers_of_still_ |= proxy.layer;
            masks_of_still_ &= proxy.collides_with;
        }
        const Vec2 size = world.max - world.min;
        constexpr double most_cells = 1 << 22;
        if (automatic_) make_room(16);
        divide(automatic_ ? std::max(size.x, size.y) : std::max(cell, smallest_cell(most_cells)));
    }

    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) override {
        pairs.clear();
        if (std::ranges::none_of(moving, &Proxy::active)) return;
        if (automatic_) fit_cell(moving);
        forget_wide();
        order_.start(first_moving(), moving.size());
        moving_ = moving;
        sort_small();
        for (const Wide& wide : wide_) look_around(wide);
        everyone_meets() ? look_around_small<true>() : look_around_small<false>();
        order_.finish(pairs);
    }

    void find_overlapping(const SingleBox& box, std::vector<Handle>& found) override {
        const auto look_at = [&](Handle handle, const Proxy& proxy) {
            ++tests_;
            if (overlap(box, proxy.box)) found.push_back(handle);
        };
        each_large_under(cells_.under(box), look_at);
        // The middles of small ones are less than half a cell inside their boxes.
        const Cells around = with_margin(box);
        for (std::uint32_t y = around.bottom; y <= around.top; ++y) {
            const Run row{begin_[cells_.at(around.left, y)], begin_[cells_.at(around.right, y) + 1]};
            // All are written, and the place is kept only where the boxes overlap: see sift.hpp.
            std::size_t count = found.size();
            found.resize(count + row.size());
            for (std::uint32_t i = row.begin; i < row.end; ++i) {
                found[count] = entries_[i].handle;
                count += static_cast<std::size_t>(overlap(box, entries_[i].box));
            }
            found.resize(count);
            tests_ += row.size();
        }
    }

    void prepare(const SingleBox& box) const override {
        const Cells large = cells_.under(box);
        for (std::uint32_t y = large.bottom; y <= large.top; ++y) {
            const Run row{still_begin_[cells_.at(large.left, y)],
                          still_begin_[cells_.at(large.right, y) + 1]};
            for (std::uint32_t i = row.begin; i < row.end; ++i) fetch(still_[still_listed_[i]]);
        }
        const Cells around = with_margin(box);
        for (std::uint32_t y = around.bottom; y <= around.top; ++y) {
            const Run row{begin_[cells_.at(around.left, y)], begin_[cells_.at(around.right, y) + 1]};
            for (std::uint32_t i = row.begin; i < row.end; ++i) fetch(entries_[i]);
        }
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        return {.name = "grid",
                .leaves = static_cast<int>(cells_.count()),
                .leaf_width = cells_.size,
                .leaf_height = cells_.size,
                .most_in_leaf = most_in_cell_};
    }

    void inspect(Inspector& inspector) const override {
        for (std::uint32_t y = 0; y < cells_.rows; ++y)
            for (std::uint32_t x = 0; x < cells_.columns; ++x) {
                const Vec2 low = cells_.corner(x, y);
                const Cell cell = cells_.at(x, y);
                std::uint32_t count = still_begin_[cell + 1] - still_begin_[cell];
                if (!begin_.empty()) count += begin_[cell + 1] - begin_[cell];
                for (std::uint32_t i = first_wide_[cell]; i != nobody; i = listings_[i].next) ++count;
                inspector.cell({low, low + Vec2{cells_.size, cells_.size}}, static_cast<int>(count));
            }
    }

  private:
    static constexpr std::uint32_t nobody = ~0U;
    /// What is at most this part of a cell is small; the rest is room for rounding.
    static constexpr double fits = 0.99;

    struct Still {
        Proxy proxy;
        Handle handle = 0;
        Cells listed;  ///< with the margin
    };
    /// A small proxy, in order of cells. Packed: half a line of the cache.
    struct alignas(32) Entry {
        SingleBox box;
        std::uint32_t layer = 0, collides_with = 0;
        Handle handle = 0;
        Cell cell : 30 = 0;
        std::uint32_t ball : 1 = 0, active : 1 = 0;
    };
    /// A moving proxy that does not fit into a cell.
    struct Wide {
        Handle handle;
        Cells cells;   ///< without the margin
        Cells listed;  ///< with it
    };
    /// What lies together in a list.
    struct Run {
        std::uint32_t begin, end;
        [[nodiscard]] std::uint32_t size() const { return end - begin; }
    };
    /// Tests of one small proxy against others, without a branch: nothing would foretell what is near.
    template <bool everyone>
    struct Looking {
        const Entry& own;
        Pair* to;
        std::uint32_t found = 0, tests = 0;

        Looking(const Entry& entry, Pair* pairs) : own(entry), to(pairs) {}
        void at(const Entry& other) {
            // The lower handle first: changed over without a branch.
            const Handle change =
                (own.handle ^ other.handle) & (0U - static_cast<Handle>(other.handle < own.handle));
            at(other, own.handle ^ change, other.handle ^ change);
        }
        void at(const auto& other, Handle low, Handle high) {
            const bool overlapping = overlap(own.box, other.box);
            to[found] = {low, high};
            if (everyone) {
                found += static_cast<std::uint32_t>(overlapping);
                return;
            }
            const bool may = may_meet(own, other);
            found += static_cast<std::uint32_t>(may & overlapping);
            tests += static_cast<std::uint32_t>(may);
        }
    };
    /// A link in the list of wide proxies of one cell.
    struct Listing {
        std::uint32_t wide;  ///< into wide_
        Cell cell;
        std::uint32_t next;
    };

    [[nodiscard]] Entry entry_of(Handle i, Cell cell) const {
        const Proxy& proxy = moving_[i];
        constexpr Cell all_bits = ~Cell{0} >> 2;
        return {proxy.box,       proxy.layer, proxy.collides_with, first_moving() + i,
                cell & all_bits, proxy.ball,  proxy.active};
    }
    [[nodiscard]] Handle first_moving() const { return static_cast<Handle>(still_.size()); }
    [[nodiscard]] const Proxy& proxy(const Wide& wide) const { return moving_[wide.handle - first_moving()]; }
    [[nodiscard]] Cells with_margin(const Box& box) const {
        return cells_.under(grown(box, 0.5 * cells_.size));
    }
    /// The smallest cell of which `most` cover the world.
    [[nodiscard]] double smallest_cell(double most) const {
        const Vec2 size = world_.max - world_.min;
        return std::max(std::sqrt(size.x * size.y / most), (size.x + size.y) / most);
    }
    /// The larger side of a box, at most the world's.
    [[nodiscard]] double side(const Box& box) const {
        const Vec2 size = box.max - box.min, whole = world_.max - world_.min;
        const double limit = std::max(whole.x, whole.y), larger = std::max(size.x, size.y);
        return larger < limit ? larger : limit;
    }

    /// Makes sure that typical boxes fit and that there are not many more cells than proxies. The cell
    /// stays while boxes fit on average and it is at most three times too large, since a change lists what
    /// is still anew.
    void fit_cell(std::span<const Proxy> moving) {
        const bool anew = moving.size() > room_;
        if (anew) make_room(std::bit_ceil(moving.size()));
        double sum = 0, most = 0;
        for (const Proxy& proxy : moving) {
            const double length = side(proxy.box);
            sum += length;
            most = std::max(most, length);
        }
        const auto count = static_cast<double>(moving.size());
        const double mean = sum / count, fewest = smallest_cell(4 * count + 256);
        const auto cell_for = [&](double largest, double means) {
            return std::max((1 + 1e-9) / fits * std::min(largest, means * mean), fewest);
        };
        const double tight = cell_for(most, 2.2);
        if (anew || 3 * tight < cells_.size)
            divide(tight);
        else if (cell_for(most, 1.8) > cells_.size)
            divide(cell_for(1.25 * most, 2.2));  // what grows may grow on
    }

    /// Lists what is still in the smallest cells that there will be for so many moving proxies, so that no
    /// later change needs to allocate.
    void make_room(std::size_t moving) {
        room_ = moving;
        divide(smallest_cell(4 * static_cast<double>(moving) + 256));
        begin_.reserve(cells_.count() + 1);
        home_.reserve(moving);
        entries_.reserve(moving);
        wide_.reserve(moving);
        custom::make_room(listings_, moving, pairs_per_ball);
        still_listed_.reserve(2 * still_listed_.size());
    }

    void divide(double size) {
        const Vec2 whole = world_.max - world_.min;
        const auto needed = [&](double length) {
            return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / size)));
        };
        cells_ = {world_.min, size, 1 / size, needed(whole.x), needed(whole.y)};
        list_still();
        first_wide_.assign(cells_.count(), nobody);
        listings_.clear();
        begin_.clear();
    }

    void list_still() {
        for (Still& still : still_) still.listed = with_margin(still.proxy.box);
        // Neighbours in the world become neighbours in memory.
        std::ranges::sort(still_, {}, [](const Still& still) {
            return std::tuple(still.listed.bottom, still.listed.left, still.handle);
        });
        still_begin_.assign(cells_.count() + 1, 0);
        for (const Still& still : still_)
            cells_.each(still.listed, [&](auto x, auto y) { ++still_begin_[cells_.at(x, y)]; });
        std::inclusive_scan(still_begin_.begin(), still_begin_.end(), still_begin_.begin());
        still_listed_.resize(still_begin_.back());
        for (auto i = first_moving(); i-- > 0;)
            cells_.each(still_[i].listed,
                        [&](auto x, auto y) { still_listed_[--still_begin_[cells_.at(x, y)]] = i; });
    }

    void forget_wide() {
        for (const Listing& listing : listings_) first_wide_[listing.cell] = nobody;
        listings_.clear();
        wide_.clear();
    }

    void list_wide(Handle handle, const Box& box) {
        const auto index = static_cast<std::uint32_t>(wide_.size());
        wide_.push_back({handle, cells_.under(box), with_margin(box)});
        cells_.each(wide_.back().listed, [&](auto x, auto y) {
            std::uint32_t& first = first_wide_[cells_.at(x, y)];
            listings_.push_back({index, cells_.at(x, y), first});
            first = static_cast<std::uint32_t>(listings_.size() - 1);
        });
    }

    /// Counts the small ones per cell, then puts each into its place. Wide ones are listed apart.
    void sort_small() {
        begin_.assign(cells_.count() + 1, 0);
        home_.clear();
        Vec2 largest;
        for (Handle i = 0; i < moving_.size(); ++i) {
            const Box& box = moving_[i].box;
            ++tests_;
            const Vec2 size = box.max - box.min;
            if (!(size.x <= fits * cells_.size && size.y <= fits * cells_.size)) {
                list_wide(first_moving() + i, box);
                home_.push_back(nobody);
                continue;
            }
            largest = {std::max(largest.x, size.x), std::max(largest.y, size.y)};
            home_.push_back(cells_.at(cells_.column(0.5 * box.min.x + 0.5 * box.max.x),
                                      cells_.row(0.5 * box.min.y + 0.5 * box.max.y)));
            ++begin_[home_.back()];
        }
        reach_ = 0.5 * largest + 1e-6 * Vec2{cells_.size, cells_.size};
        std::uint32_t sum = 0, most = 0;
        for (std::uint32_t& count : begin_) {
            most = std::max(most, count);
            count = sum += count;
        }
        most_in_cell_ = static_cast<int>(most);
        entries_.resize(sum);
        // Their places lie anywhere in memory.
        const auto prepare = [&](std::uint32_t i) {
            if (home_[i] != nobody) fetch(entries_[begin_[home_[i]] - 1]);
        };
        each_prepared(Places{0, moving_.size()}, prepare, [&](std::uint32_t i) {
            if (home_[i] != nobody) entries_[--begin_[home_[i]]] = entry_of(i, home_[i]);
        });
    }

    [[nodiscard]] bool everyone_meets() const {
        if (entries_.empty()) return false;
        const Entry& one = entries_.front();
        const auto alike = [&](const Entry& entry) {
            return ((entry.active & entry.ball) != 0) & (entry.layer == one.layer) &
                   (entry.collides_with == one.collides_with);
        };
        return layers_meet(one, one) && (one.layer & masks_of_still_) != 0 &&
               (layers_of_still_ & ~one.collides_with) == 0 && std::ranges::all_of(entries_, alike);
    }

    /// Each small one against what is still or wide in its cell and the small ones after it. `everyone`:
    /// any two may meet, so that need not be asked.
    template <bool everyone>
    void look_around_small() {
        const Entry* const entries = entries_.data();
        const std::uint32_t* const begin = begin_.data();
        const auto count = static_cast<std::uint32_t>(entries_.size());
        std::uint32_t row = 0;
        Cell past_row = cells_.columns;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Entry& entry = entries[i];
            const Cell cell = entry.cell;
            for (; cell >= past_row; past_row += cells_.columns) ++row;
            const std::uint32_t column = cell + cells_.columns - past_row;
            // Neighbours whose middles the largest small box around can have.
            const Box& box = entry.box;
            const Vec2 low = cells_.corner(column, row);
            const bool left = (column > 0) & (box.min.x - reach_.x <= low.x);
            const bool right = (column + 1 < cells_.columns) & (box.max.x + reach_.x >= low.x + cells_.size);
            const bool above = (row + 1 < cells_.rows) & (box.max.y + reach_.y >= low.y + cells_.size);
            const Cell past = cell + (right ? 2 : 1), over = above ? cells_.columns : 0;
            const Run still{still_begin_[cell], still_begin_[cell + 1]};
            const Run rest{i + 1, begin[past]};
            const Cell next = cell - (left ? 1 : 0) + over;
            const Run next_row{begin[next], begin[next + (past + over - next) * Cell{above}]};

            Looking<everyone> look(entry, order_.room_for(still.size() + rest.size() + next_row.size()));
            const Handle* const listed = still_listed_.data();
            for (std::uint32_t k = still.begin; k < still.end; ++k) {
                const Still& other = still_[listed[k]];
                look.at(other.proxy, other.handle, entry.handle);
            }
            // Both runs in one loop: where a loop ends nothing foretells.
            const std::uint32_t gap = next_row.begin - rest.end;
            for (std::uint32_t k = 0; k < rest.size() + next_row.size(); ++k)
                look.at(entries[rest.begin + k + gap * static_cast<std::uint32_t>(k >= rest.size())]);
            tests_ += everyone ? still.size() + rest.size() + next_row.size() : look.tests;
            order_.took(look.found);
            if (!wide_.empty()) look_at_wide(entry, cell);
        }
    }

    void look_at_wide(const Entry& entry, Cell cell) {
        for (std::uint32_t k = first_wide_[cell]; k != nobody; k = listings_[k].next) {
            const Wide& wide = wide_[listings_[k].wide];
            test(entry, entry.handle, proxy(wide), wide.handle);
        }
    }

    /// Visits what is still or wide and overlaps given cells, each in the first of these.
    void each_large_under(const Cells& cells, auto&& visit) const {
        const auto is_first = [&](const Cells& other, std::uint32_t x, std::uint32_t y) {
            return x == std::max(cells.left, other.left) && y == std::max(cells.bottom, other.bottom);
        };
        cells_.each(cells, [&](auto x, auto y) {
            const Cell cell = cells_.at(x, y);
            for (std::uint32_t k = still_begin_[cell]; k < still_begin_[cell + 1]; ++k)
                if (const Still& still = still_[still_listed_[k]]; is_first(still.listed, x, y))
                    visit(still.handle, still.proxy);
            for (std::uint32_t k = first_wide_[cell]; k != nobody; k = listings_[k].next)
                if (const Wide& wide = wide_[listings_[k].wide]; is_first(wide.listed, x, y))
                    visit(wide.handle, proxy(wide));
        });
    }

    /// A wide one against what is still and the wide ones before it.
    void look_around(const Wide& wide) {
        each_large_under(wide.cells, [&](Handle other, const Proxy& large) {
            if (other < wide.handle) test(proxy(wide), wide.handle, large, other);
        });
    }

    void test(const auto& a, Handle handle_a, const Proxy& b, Handle handle_b) {
        if (!may_meet(a, b)) return;
        ++tests_;
        if (overlap(a.box, b.box)) order_.add(handle_a, handle_b);
    }

    std::vector<Still> still_;            ///< in order of cells
    std::uint32_t layers_of_still_ = 0;   ///< of any
    std::uint32_t masks_of_still_ = ~0U;  ///< of all
    Box world_;
    bool automatic_;
    std::size_t room_ = 0;  ///< moving proxies for which there is room without allocation
    Division cells_;
    std::vector<std::uint32_t> still_begin_;   ///< per cell and one more: where its part begins of
    std::vector<std::uint32_t> still_listed_;  ///< into still_

    std::span<const Proxy> moving_;
    std::vector<Cell> home_;            ///< per moving proxy; nobody's for the wide
    std::vector<std::uint32_t> begin_;  ///< per cell and one more: where its part of entries_ begins
    std::vector<Entry> entries_;
    Vec2 reach_;  ///< half of the largest small box, and room for rounding
    std::vector<Wide> wide_;
    std::vector<std::uint32_t> first_wide_;  ///< per cell: into listings_, or nobody
    std::vector<Listing> listings_;
    PairOrder order_;
    int most_in_cell_ = 0;
};

}  // namespace

std::unique_ptr<BroadPhase> make_grid(const std::vector<Proxy>& still, const Box& world, double cell) {
    return std::make_unique<Grid>(still, world, cell);
}

}  // namespace flipside::custom
