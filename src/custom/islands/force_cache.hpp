#pragma once
/// The contact forces of the previous tick, from which a solve starts (warm starting). Sorted by ball.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "world/state.hpp"

namespace flipside::custom {

class ForceCache {
  public:
    void reserve(std::size_t forces) { forces_.reserve(forces), merged_.reserve(forces); }
    void clear() { forces_.clear(), sorted_ = first_ = 0; }

    /// Removes the forces for which `holds` is true.
    void forget_if(auto&& holds) {
        std::erase_if(forces_, holds);
        sorted_ = forces_.size();
    }
    /// Adds a force; find() sees it after merge().
    void add(const ContactForce& force) { forces_.push_back(force); }
    /// Merges the new forces into the sorted ones. Cost: a sort of the new ones, and one pass.
    void merge() {
        const auto middle = forces_.begin() + static_cast<std::ptrdiff_t>(sorted_);
        std::ranges::sort(middle, forces_.end(), {}, rank);
        merged_.clear();
        std::ranges::merge(forces_.begin(), middle, middle, forces_.end(), std::back_inserter(merged_), {},
                           rank, rank);
        std::swap(forces_, merged_);
        sorted_ = forces_.size();
    }

    /// Starts a new pass of lookups.
    void rewind() { first_ = 0; }
    /// Advances to the forces of ball `b`, which rises from call to call. Cost: one pass for all calls
    /// together.
    void advance_to(std::uint32_t b) {
        while (first_ < forces_.size() && forces_[first_].b < b) ++first_;
    }
    /// The force between a and b, or null if there was none. Cost: constant for the `b` of the last
    /// advance_to(), else a binary search.
    [[nodiscard]] const ContactForce* find(std::uint32_t a, std::uint32_t b) const {
        const auto ahead = all().subspan(first_);
        const bool here = ahead.empty() || ahead.front().b >= b;
        auto force = here ? ahead.begin() : std::ranges::lower_bound(ahead, rank({a, b}), {}, rank);
        while (force != ahead.end() && force->b == b && force->a < a) ++force;
        return force != ahead.end() && force->b == b && force->a == a ? &*force : nullptr;
    }
    /// Sorted by `b`, then `a`.
    [[nodiscard]] std::span<const ContactForce> all() const { return forces_; }

  private:
    [[nodiscard]] static std::uint64_t rank(const ContactForce& force) {
        return std::uint64_t{force.b} << 32 | force.a;
    }

    std::vector<ContactForce> forces_;  ///< the sorted forces, then the new ones
    std::vector<ContactForce> merged_;  ///< buffer of merge()
    std::size_t sorted_ = 0;
    std::size_t first_ = 0;
};

}  // namespace flipside::custom
