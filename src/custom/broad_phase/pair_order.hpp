#pragma once
/// Puts pairs in order. A broad phase meets them place by place; how it goes about must not be seen from
/// outside.

#include <algorithm>

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

class PairOrder {
  public:
    /// Empty again; `first` is the handle of the first of `moving` moving proxies.
    void start(Handle first, std::size_t moving);
    /// Of two overlapping proxies, in either order.
    void add(Handle a, Handle b) {
        *room_for(1) = {std::min(a, b), std::max(a, b)};
        took(1);
    }
    /// Room for `count` more, for those who write many; took() says how many of these they wrote. In each
    /// a < b.
    [[nodiscard]] Pair* room_for(std::size_t count) {
        if (found_.size() < count_ + count) found_.resize(2 * (count_ + count));
        return found_.data() + count_;
    }
    void took(std::size_t count) { count_ += count; }
    /// Replaces `pairs` by what was added, in order. A counting sort by the lower handle, and one by the
    /// higher that keeps this order: linear, and nothing to guess.
    void finish(std::vector<Pair>& pairs);

  private:
    Handle first_ = 0;
    std::vector<Pair> found_;  ///< the first count_ of these
    std::size_t count_ = 0;
    std::vector<Pair> by_lower_;                     ///< in order of the lower handle
    std::vector<std::uint32_t> end_of_lower_, end_;  ///< per lower and per higher handle: where its pairs end
};

/// Adds `fresh` pairs, in any order and some of them twice or listed already, to `listed` ones, which are in
/// order. Uses them up as scratch, and `places`.
void add_pairs(std::vector<Pair>& fresh, std::vector<Pair>& listed, std::vector<std::size_t>& places);

}  // namespace flipside::custom
