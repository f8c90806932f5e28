// Sweep and prune: proxies in order of their left sides; each is tested against those that begin before it
// ends. The order of the last search is the start of the next sort, which then has little to do. Still
// proxies are sorted once; the two orders are swept together, as in merging, so that pairs of still
// ones are never looked at.
//
// Every comparison of two boxes counts as one box test, be it of one side (in sorting, and where a sweep
// ends) or of all four.
// Cost: O(n + pairs that share an x) while things move little, so about n^1.5 for an even spread.
// Baraff 1992, "Dynamic simulation of non-penetrating rigid bodies"; Cohen et al. 1995, "I-COLLIDE".

#include <algorithm>

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

/// A proxy by the place of its left side. Equal ones are in order of handles, so the order is one only.
struct Edge {
    double left;
    Handle proxy;
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

class Sweep final : public BroadPhase {
  public:
    explicit Sweep(std::vector<Proxy> still) : still_(std::move(still)) {
        for (Handle i = 0; i < still_.size(); ++i) still_order_.push_back({still_[i].box.min.x, i});
        std::ranges::sort(still_order_);
    }

    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) override {
        pairs.clear();
        if (std::ranges::none_of(moving, &Proxy::active)) return;
        moving_ = moving;
        sort();
        const auto first = static_cast<Handle>(still_.size());
        auto still = still_order_.begin();
        for (auto edge = order_.begin(); edge != order_.end(); ++edge) {
            const Proxy& b = moving[edge->proxy];
            for (; still != still_order_.end() && still->left <= edge->left; ++still)
                sweep(still_[still->proxy], still->proxy, edge, order_.end(), moving, first, pairs);
            sweep(b, first + edge->proxy, still, still_order_.end(), still_, 0, pairs);
            sweep(b, first + edge->proxy, edge + 1, order_.end(), moving, first, pairs);
        }
        std::ranges::sort(pairs);
    }

    [[nodiscard]] BroadPhaseFacts facts() const override { return {.name = "sweep and prune"}; }
    void inspect(Inspector&) const override {}

  private:
    using Position = std::vector<Edge>::const_iterator;

    /// Tests a proxy against those of an order from `from` on that begin before it ends.
    void sweep(const Proxy& a, Handle handle, Position from, Position to, std::span<const Proxy> others,
               Handle first, std::vector<Pair>& pairs) {
        for (; from != to; ++from) {
            if (from->left > a.box.max.x) {
                ++tests_;
                return;
            }
            test(handle, a, first + from->proxy, others[from->proxy], pairs);
        }
    }

    /// By insertion, which is linear for what is nearly in order; by halves when that turns out too slow.
    void sort() {
        if (order_.size() != moving_.size()) {
            order_.resize(moving_.size());
            for (Handle i = 0; i < order_.size(); ++i) order_[i].proxy = i;
        }
        for (Edge& edge : order_) edge.left = moving_[edge.proxy].box.min.x;
        const std::uint64_t enough = tests_ + 8 * order_.size();
        for (std::size_t i = 1; i < order_.size(); ++i) {
            if (tests_ > enough) return sort_by_halves();
            const Edge edge = order_[i];
            std::size_t at = i;
            for (; at > 0; --at) {
                ++tests_;
                if (order_[at - 1] <= edge) break;
                order_[at] = order_[at - 1];
            }
            order_[at] = edge;
        }
    }
    void sort_by_halves() {
        std::ranges::sort(order_, [&](const Edge& a, const Edge& b) {
            ++tests_;
            return a < b;
        });
    }

    std::vector<Proxy> still_;
    std::vector<Edge> still_order_;
    std::span<const Proxy> moving_;
    std::vector<Edge> order_;  ///< of the moving ones, by index into moving_
};

}  // namespace

std::unique_ptr<BroadPhase> make_sweep(std::vector<Proxy> still) {
    return std::make_unique<Sweep>(std::move(still));
}

}  // namespace flipside::custom
