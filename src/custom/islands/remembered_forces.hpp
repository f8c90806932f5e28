#pragma once
/// The forces of the tick before, from which a solve begins (warm starting), looked up ball by ball.

#include <algorithm>
#include <span>
#include <utility>

#include "world/state.hpp"

namespace flipside::custom {

/// By `b`, then `a`: the order in which forces are kept.
[[nodiscard]] inline std::pair<BallNumber, BallNumber> rank(const ContactForce& force) {
    return {force.b, force.a};
}

class RememberedForces {
  public:
    /// Of a sorted list, which must outlive this.
    explicit RememberedForces(std::span<const ContactForce> forces) : forces_(forces) {}

    /// Goes on to the forces whose `b` this is; no less than the last. Cost: all calls together, one pass.
    void go_on_to(BallNumber b) {
        while (first_ < forces_.size() && forces_[first_].b < b) ++first_;
    }
    /// That between these two; nothing if they did not press. Cost: constant, where `b` is the one that was
    /// gone on to; else that of a binary search.
    [[nodiscard]] const ContactForce* find(BallNumber a, BallNumber b) const {
        const auto ahead = forces_.subspan(first_);
        const bool here = ahead.empty() || ahead.front().b >= b;
        auto force = here ? ahead.begin() : std::ranges::lower_bound(ahead, std::pair{b, a}, {}, rank);
        while (force != ahead.end() && force->b == b && force->a < a) ++force;
        return force != ahead.end() && force->b == b && force->a == a ? &*force : nullptr;
    }

  private:
    std::span<const ContactForce> forces_;
    std::size_t first_ = 0;
};

}  // namespace flipside::custom
