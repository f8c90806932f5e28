#pragma once
/// A few boxes that come one at a time and are looked up by overlap: in a row by their left sides, except for
/// the last that came.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "custom/broad_phase/room.hpp"
#include "custom/geometry/single_box.hpp"

namespace flipside::custom {

class BoxRow {
  public:
    void reserve(std::size_t boxes) { make_room(row_, boxes); }
    void clear() {
        row_.clear();
        sorted_ = 0;
        widest_ = 0;
    }
    [[nodiscard]] std::size_t size() const { return row_.size(); }
    void add(std::uint32_t name, const SingleBox& box) {
        row_.push_back({box, name});
        widest_ = std::max(widest_, box.right() - box.left());
    }
    /// Visits the names of all whose boxes overlap this one. Gives the number of tests.
    /// Cost: O(log n + those beside it); now and then a sort.
    std::uint64_t each_overlapping(const SingleBox& box, auto&& visit) {
        constexpr std::size_t most_unsorted = 32;
        if (row_.size() - sorted_ > most_unsorted) {
            std::ranges::sort(row_, {}, left);
            sorted_ = row_.size();
        }
        const auto middle = row_.begin() + static_cast<std::ptrdiff_t>(sorted_);
        const auto first = std::ranges::lower_bound(row_.begin(), middle, box.left() - widest_, {}, left);
        const auto last = std::ranges::upper_bound(first, middle, box.right(), {}, left);
        for (auto one = first; one != last; ++one)
            if (overlap(box, one->box)) visit(one->name);
        for (auto one = middle; one != row_.end(); ++one)
            if (overlap(box, one->box)) visit(one->name);
        return static_cast<std::uint64_t>((last - first) + (row_.end() - middle));
    }

  private:
    struct Named {
        SingleBox box;
        std::uint32_t name;
    };
    static double left(const Named& named) { return named.box.left(); }

    std::vector<Named> row_;
    std::size_t sorted_ = 0;  ///< so many of them
    double widest_ = 0;       ///< m
};

}  // namespace flipside::custom
