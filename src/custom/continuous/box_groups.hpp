#pragma once
/// Boxes that seldom change, searched for those that overlap one: in groups of neighbours in the list, which
/// are neighbours on the table too where they belong to one part. Cost: a test per group, and one per box of
/// the groups hit; for the 200 pieces of a pinball table about a quarter of testing all.

#include <cstdint>
#include <vector>

#include "custom/geometry/bounds.hpp"

namespace flipside::custom {

class BoxGroups {
  public:
    [[nodiscard]] std::size_t size() const { return boxes_.size(); }
    [[nodiscard]] const Box& operator[](std::size_t i) const { return boxes_[i]; }

    void add(const Box& box) {
        if (boxes_.size() % group == 0) groups_.push_back(nowhere);
        boxes_.push_back(box);
        groups_.back() = united(groups_.back(), box);
    }
    void set(std::size_t i, const Box& box) {
        boxes_[i] = box;
        const std::size_t first = i - i % group;
        Box all = nowhere;
        for (std::size_t k = first; k < first + group && k < boxes_.size(); ++k) all = united(all, boxes_[k]);
        groups_[i / group] = all;
    }
    /// Appends the indices of all that overlap `box`, in rising order. Returns the number of box tests.
    std::uint64_t find(const Box& box, std::vector<std::uint32_t>& found) const {
        std::uint64_t tests = groups_.size();
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            if (!overlap(box, groups_[g])) continue;
            const std::size_t last = std::min(boxes_.size(), (g + 1) * group);
            tests += last - g * group;
            // Without a branch per box, see sift.hpp.
            std::size_t count = found.size();
            found.resize(count + group);
            for (std::size_t i = g * group; i < last; ++i) {
                found[count] = static_cast<std::uint32_t>(i);
                count += static_cast<std::size_t>(overlap(box, boxes_[i]));
            }
            found.resize(count);
        }
        return tests;
    }

    /// Overlaps nothing.
    static constexpr Box nowhere{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

  private:
    static constexpr std::size_t group = 8;
    std::vector<Box> boxes_, groups_;
};

}  // namespace flipside::custom
