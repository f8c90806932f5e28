#pragma once
/// Puts pairs in order. A broad phase meets them place by place; how it goes about must not be seen from
/// outside.

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

class PairOrder {
  public:
    /// Empty again; `first` is the handle of the first of `moving` moving proxies.
    void start(Handle first, std::size_t moving);
    /// Of two overlapping proxies, in either order.
    void add(Handle a, Handle b) { found_.push_back(a < b ? Pair{a, b} : Pair{b, a}); }
    /// Replaces `pairs` by what was added, in order. A counting sort by the higher handle, and a short
    /// sort among the few pairs that share one: linear where no proxy has many partners.
    void finish(std::vector<Pair>& pairs);

  private:
    Handle first_ = 0;
    std::vector<Pair> found_;
    std::vector<std::uint32_t> end_;  ///< per moving proxy: where its pairs end
};

}  // namespace flipside::custom
