#include "world/crowding.hpp"

#include <algorithm>
#include <tuple>

#include "world/bounds.hpp"

namespace flipside {

namespace {

/// Sums of counts by rank (Fenwick 1994, "A new data structure for cumulative frequency tables").
class Counts {
  public:
    explicit Counts(std::size_t ranks) : sums_(ranks + 1) {}

    void add(std::size_t rank, int change) {
        for (std::size_t i = rank + 1; i < sums_.size(); i += i & (~i + 1)) sums_[i] += change;
    }
    /// Of all ranks below this one.
    [[nodiscard]] std::int64_t below(std::size_t rank) const {
        std::int64_t sum = 0;
        for (std::size_t i = rank; i > 0; i &= i - 1) sum += sums_[i];
        return sum;
    }

  private:
    std::vector<std::int32_t> sums_;
};

/// Things that all meet the same others.
struct Kind {
    Boxed like;
    bool meets_all = false;
    std::int64_t open = 0;  ///< boxes that the sweep is in
    Counts lows, highs;     ///< of these, by the ranks of their least and greatest y

    [[nodiscard]] bool holds(const Boxed& thing) const {
        return meets_all || std::tie(thing.is_ball, thing.layer, thing.collides_with) ==
                                std::tie(like.is_ball, like.layer, like.collides_with);
    }
    [[nodiscard]] bool meets(const Boxed& thing) const {
        return meets_all || (!thing.is_ball && !like.is_ball) || layers_meet(thing, like);
    }
    void change(std::size_t low, std::size_t high, int by) {
        open += by;
        lows.add(low, by);
        highs.add(high, by);
    }
};

/// The ends of the boxes along y, sorted.
std::vector<double> sorted_ends(std::span<const Boxed> things, Vec2 Box::*end) {
    std::vector<double> values;
    for (const Boxed& thing : things) values.push_back((thing.box.*end).y);
    std::ranges::sort(values);
    return values;
}

/// A sweep from left to right.
class Sweep {
  public:
    explicit Sweep(std::span<const Boxed> things)
        : things_(things),
          lows_(sorted_ends(things, &Box::min)),
          highs_(sorted_ends(things, &Box::max)),
          kind_of_(things.size()) {}

    std::optional<std::size_t> crowded_at(std::uint64_t most) {
        struct End {
            double x;
            bool closes;
            std::uint32_t thing;
        };
        std::vector<End> ends;
        ends.reserve(2 * things_.size());
        for (std::uint32_t i = 0; i < things_.size(); ++i) {
            ends.push_back({things_[i].box.min.x, false, i});
            ends.push_back({things_[i].box.max.x, true, i});
        }
        std::ranges::sort(ends, {}, [](const End& end) { return std::tuple(end.x, end.closes, end.thing); });
        std::uint64_t pairs = 0;
        for (const End& end : ends) {
            if (!end.closes) pairs += static_cast<std::uint64_t>(open(end.thing));
            if (end.closes) change(end.thing, -1);
            if (pairs > most) return end.thing;
        }
        return std::nullopt;
    }

  private:
    /// Opens the box of a thing, and returns how many open ones it overlaps.
    std::int64_t open(std::uint32_t thing) {
        const Boxed& opened = things_[thing];
        const auto below =
            static_cast<std::size_t>(std::ranges::lower_bound(highs_, opened.box.min.y) - highs_.begin());
        const auto not_above =
            static_cast<std::size_t>(std::ranges::upper_bound(lows_, opened.box.max.y) - lows_.begin());
        std::int64_t overlapped = 0;
        for (const Kind& kind : kinds_) {
            if (!kind.meets(opened)) continue;
            const std::int64_t above = kind.open - kind.lows.below(not_above);
            overlapped += kind.open - above - kind.highs.below(below);
        }
        kind_of_[thing] = kind_of(opened);
        change(thing, 1);
        return overlapped;
    }

    void change(std::uint32_t thing, int by) {
        const Box& box = things_[thing].box;
        const auto low = std::ranges::lower_bound(lows_, box.min.y) - lows_.begin();
        const auto high = std::ranges::lower_bound(highs_, box.max.y) - highs_.begin();
        kinds_[kind_of_[thing]].change(static_cast<std::size_t>(low), static_cast<std::size_t>(high), by);
    }

    std::uint8_t kind_of(const Boxed& thing) {
        constexpr std::size_t most_kinds = 8;
        const auto found = std::ranges::find_if(kinds_, [&](const Kind& kind) { return kind.holds(thing); });
        const auto index = static_cast<std::uint8_t>(found - kinds_.begin());
        if (found == kinds_.end())
            kinds_.push_back(
                {thing, kinds_.size() + 1 == most_kinds, 0, Counts(things_.size()), Counts(things_.size())});
        return index;
    }

    std::span<const Boxed> things_;
    std::vector<double> lows_, highs_;
    std::vector<Kind> kinds_;
    std::vector<std::uint8_t> kind_of_;
};

struct AppendBoxes {
    std::vector<Box>& boxes;

    void line(Vec2 a, Vec2 b, double radius_a = 0, double radius_b = 0) const {
        boxes.push_back(united(bounds_of(a, radius_a), bounds_of(b, radius_b)));
    }
    void operator()(const shape::Point& s) const { boxes.push_back(bounds_of(s.at, 0)); }
    void operator()(const shape::Segment& s) const { line(s.a, s.b); }
    void operator()(const shape::Arc& s) const { boxes.push_back(bounds_of(s.center, s.radius)); }
    void operator()(const shape::Circle& s) const { boxes.push_back(bounds_of(s.center, s.radius)); }
    void operator()(const shape::Polygon& s) const {
        Box box = bounds_of(s.points.front(), 0);
        for (const Vec2 point : s.points) box = united(box, bounds_of(point, 0));
        boxes.push_back(box);
    }
    void operator()(const shape::Capsule& s) const { line(s.a, s.b, s.radius, s.radius); }
    void operator()(const shape::Flipper& s) const {
        line(s.pivot, s.pivot + s.length * from_angle(s.rest), s.base_radius, s.tip_radius);
    }
    void operator()(const shape::Polyline& s) const {
        for (std::size_t i = 1; i < s.points.size(); ++i) line(s.points[i - 1], s.points[i]);
        if (s.closed) line(s.points.back(), s.points.front());
    }
    void operator()(const shape::Gate& s) const { line(s.a, s.b); }
    void operator()(const shape::Compound& s) const {
        for (const Shape& member : s.of) append_boxes(member, boxes);
    }
};

}  // namespace

std::optional<std::size_t> crowded_at(std::span<const Boxed> things, std::uint64_t most) {
    const std::uint64_t n = things.size();
    if (n < 2 || n * (n - 1) / 2 <= most) return std::nullopt;
    return Sweep(things).crowded_at(most);
}

void append_boxes(const Shape& shape, std::vector<Box>& boxes) {
    std::visit(AppendBoxes{boxes}, shape.is);
}

}  // namespace flipside
