// Sweep and prune: proxies are sorted by their left sides, and each is tested against those that begin before
// it ends. The order of the last search is the start of the next sort, which then has little to do. Still
// proxies are sorted once; both orders are swept together, like in a merge, so that pairs of still proxies
// are never tested.
//
// Every comparison of two boxes counts as one box test, also that of one side (at the end of a sweep, and in
// sorting: n log₂ n for std::sort). Cost: O(n + pairs that share an x) while positions change little, so
// about n^1.5 for an even distribution. Baraff 1992, "Dynamic simulation of non-penetrating rigid bodies";
// Cohen et al. 1995, "I-COLLIDE".

#include <algorithm>
#include <bit>

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

/// The left side of a proxy. Equal ones are sorted by handle, so that the order is unique.
struct Edge {
    double left;
    Handle proxy;
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

class Sweep final : public BroadPhase {
  public:
    explicit Sweep(std::vector<Proxy> still) : BroadPhase(std::move(still)) {
        for (Handle i = 0; i < first_moving_; ++i) still_order_.push_back({proxies_[i].box.min.x, i});
        std::ranges::sort(still_order_);
    }

    [[nodiscard]] BroadPhaseFacts facts() const override { return {.name = "sweep and prune"}; }

  private:
    using Position = std::vector<Edge>::const_iterator;

    void search() override {
        sort();
        auto still = still_order_.cbegin();
        for (auto edge = order_.cbegin(); edge != order_.cend(); ++edge) {
            const Handle b = edge->proxy;
            for (; still != still_order_.cend() && still->left <= edge->left; ++still)
                sweep(still->proxy, edge, order_.cend(), [&](Handle other) { test(still->proxy, other); });
            sweep(b, still, still_order_.cend(), [&](Handle other) { test(other, b); });
            sweep(b, edge + 1, order_.cend(), [&](Handle other) { test(b, other); });
        }
    }

    /// Tests a proxy against those of an order, starting at `from`, that begin before it ends.
    void sweep(Handle a, Position from, Position to, auto&& visit) {
        for (; from != to; ++from) {
            if (from->left > proxies_[a].box.max.x) {
                ++tests_;
                return;
            }
            visit(from->proxy);
        }
    }

    /// Insertion sort, which is linear for an almost sorted list; std::sort if that takes too long.
    void sort() {
        if (order_.size() != moving()) {
            order_.resize(moving());
            for (Handle i = 0; i < order_.size(); ++i) order_[i].proxy = first_moving_ + i;
        }
        for (Edge& edge : order_) edge.left = proxies_[edge.proxy].box.min.x;
        const std::uint64_t enough = tests_ + 8 * order_.size();
        const auto is_before = [&](const Edge& a, const Edge& b) {
            ++tests_;
            return a < b;
        };
        for (std::size_t i = 1; i < order_.size(); ++i) {
            if (tests_ > enough) {
                tests_ += order_.size() * std::bit_width(order_.size());
                std::ranges::sort(order_);
                return;
            }
            const Edge edge = order_[i];
            std::size_t at = i;
            for (; at > 0 && is_before(edge, order_[at - 1]); --at) order_[at] = order_[at - 1];
            order_[at] = edge;
        }
    }

    std::vector<Edge> still_order_;
    std::vector<Edge> order_;  ///< of the moving proxies
};

}  // namespace

std::unique_ptr<BroadPhase> make_sweep(std::vector<Proxy> still, const BroadPhaseOptions&) {
    return std::make_unique<Sweep>(std::move(still));
}

}  // namespace flipside::custom
