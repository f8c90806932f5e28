#pragma once
/// The forces of the tick before, from which a solve begins (warm starting), looked up ball by ball.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "world/state.hpp"

namespace flipside::custom {

class RememberedForces {
  public:
    void reserve(std::size_t forces) { forces_.reserve(forces), merged_.reserve(forces); }
    void clear() { forces_.clear(), settled_ = first_ = 0; }

    /// Forgets the forces of which this holds.
    void forget_if(auto&& holds) {
        std::erase_if(forces_, holds);
        settled_ = forces_.size();
    }
    /// Remembers a new force; it is not found before settle().
    void add(const ContactForce& force) { forces_.push_back(force); }
    /// Puts the new forces where they belong. Cost: a sort of the new ones, and one pass.
    void settle() {
        const auto middle = forces_.begin() + static_cast<std::ptrdiff_t>(settled_);
        std::ranges::sort(middle, forces_.end(), {}, rank);
        merged_.clear();
        std::ranges::merge(forces_.begin(), middle, middle, forces_.end(), std::back_inserter(merged_), {},
                           rank, rank);
        std::swap(forces_, merged_);
        settled_ = forces_.size();
    }

    /// From here on forces are looked up anew.
    void start() { first_ = 0; }
    /// Goes on to the forces whose `b` this is; no less than the last. Cost: all calls together, one pass.
    void go_on_to(std::uint32_t b) {
        while (first_ < forces_.size() && forces_[first_].b < b) ++first_;
    }
    /// That between these two; nothing if they did not press. Cost: constant, where `b` is the one that was
    /// gone on to; else that of a binary search.
    [[nodiscard]] const ContactForce* find(std::uint32_t a, std::uint32_t b) const {
        const auto ahead = all().subspan(first_);
        const bool here = ahead.empty() || ahead.front().b >= b;
        auto force = here ? ahead.begin() : std::ranges::lower_bound(ahead, rank({a, b}), {}, rank);
        while (force != ahead.end() && force->b == b && force->a < a) ++force;
        return force != ahead.end() && force->b == b && force->a == a ? &*force : nullptr;
    }
    /// By `b`, then `a`.
    [[nodiscard]] std::span<const ContactForce> all() const { return forces_; }

  private:
    [[nodiscard]] static std::uint64_t rank(const ContactForce& force) {
        return std::uint64_t{force.b} << 32 | force.a;
    }

    std::vector<ContactForce> forces_;  ///< those that are settled, in order, and the new ones
    std::vector<ContactForce> merged_;  ///< scratch
    std::size_t settled_ = 0;
    std::size_t first_ = 0;
};

}  // namespace flipside::custom
