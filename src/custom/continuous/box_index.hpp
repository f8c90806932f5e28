#pragma once
/// Boxes that seldom change, searched for those that overlap one. Each axis of the table is cut into slabs.
/// For every slab there are two sets of boxes, a bit per box: those that begin in it or before, and those
/// that end in it or after. What can overlap a box is in four of these sets at once, and only that is tested
/// (the bitmaps of O'Neil, Quass 1997, "Improved query performance with variant indexes", in two dimensions).
/// Cost: n/16 words read, and a test per box nearby.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "custom/geometry/bounds.hpp"

namespace flipside::custom {

class BoxIndex {
  public:
    /// Of `count` boxes that overlap nothing yet; most of them will lie in `range`.
    BoxIndex(const Box& range, std::size_t count)
        : x_(range.min.x, range.max.x),
          y_(range.min.y, range.max.y),
          boxes_(count, nowhere),
          words_((count + bits - 1) / bits),
          sets_(sides * slabs * words_) {}

    [[nodiscard]] std::size_t size() const { return boxes_.size(); }
    [[nodiscard]] const Box& operator[](std::size_t i) const { return boxes_[i]; }

    void set(std::size_t i, const Box& box) {
        boxes_[i] = box;
        const std::uint64_t bit = std::uint64_t{1} << i % bits;
        const auto mark = [&](Side side, std::size_t first, std::size_t last) {
            for (std::size_t slab = 0; slab < slabs; ++slab) {
                std::uint64_t& word = sets_[place(side, slab) + i / bits];
                word = slab >= first && slab <= last ? word | bit : word & ~bit;
            }
        };
        mark(begins_x, x_.slab(box.min.x), slabs);
        mark(begins_y, y_.slab(box.min.y), slabs);
        mark(ends_x, 0, x_.slab(box.max.x));
        mark(ends_y, 0, y_.slab(box.max.y));
    }

    /// Visits the indices of all that may overlap `box`, in rising order: to find its slabs counts as one box
    /// test.
    void each_near(const Box& box, auto&& visit) const {
        const std::uint64_t* const a = sets_.data() + place(begins_x, x_.slab(box.max.x));
        const std::uint64_t* const b = sets_.data() + place(begins_y, y_.slab(box.max.y));
        const std::uint64_t* const c = sets_.data() + place(ends_x, x_.slab(box.min.x));
        const std::uint64_t* const d = sets_.data() + place(ends_y, y_.slab(box.min.y));
        for (std::size_t w = 0; w < words_; ++w)
            for (std::uint64_t near = a[w] & b[w] & c[w] & d[w]; near != 0; near &= near - 1)
                visit(
                    static_cast<std::uint32_t>(w * bits + static_cast<std::size_t>(std::countr_zero(near))));
    }
    /// Appends the indices of all that overlap `box`, in rising order. Returns the number of box tests.
    std::uint64_t find(const Box& box, std::vector<std::uint32_t>& found) const {
        std::uint64_t tests = 1;
        each_near(box, [&](std::uint32_t i) {
            ++tests;
            if (overlap(box, boxes_[i])) found.push_back(i);
        });
        return tests;
    }

    /// Overlaps nothing.
    static constexpr Box nowhere{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

  private:
    static constexpr std::size_t bits = 64, slabs = 64, sides = 4;
    enum Side : std::size_t { begins_x, begins_y, ends_x, ends_y };

    struct Axis {
        double low, per_slab;

        Axis(double min, double max)
            : low(min), per_slab(max > min ? static_cast<double>(slabs) / (max - min) : 0) {}
        /// Of a coordinate; what is outside, at infinity too, is in the first or the last.
        [[nodiscard]] std::size_t slab(double at) const {
            const double place = (at - low) * per_slab;
            return place > 0 ? static_cast<std::size_t>(std::min(place, slabs - 1.0)) : 0;
        }
    };
    [[nodiscard]] std::size_t place(Side side, std::size_t slab) const {
        return (side * slabs + slab) * words_;
    }

    Axis x_, y_;
    std::vector<Box> boxes_;
    std::size_t words_;                ///< per set
    std::vector<std::uint64_t> sets_;  ///< by side, then slab
};

}  // namespace flipside::custom
