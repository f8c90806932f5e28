// For a few moving proxies: each asks an index of what is still, and all of them are tested against each
// other. Nothing is sorted or listed anew, so a search costs no more than its answer is worth.
// Cost: O(n · (still / 16 + n)).

#include <algorithm>

#include "custom/broad_phase/box_index.hpp"
#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

class Few final : public BroadPhase {
  public:
    Few(const std::vector<Proxy>& still, const Box& world) : still_(still), index_(world, still.size()) {
        for (std::size_t i = 0; i < still.size(); ++i) index_.set(i, still[i].box);
    }

    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) override {
        pairs.clear();
        moving_ = moving;
        if (std::ranges::none_of(moving, &Proxy::active)) return;
        for (Handle b = 0; b < moving.size(); ++b) {
            const Proxy& proxy = moving[b];
            const auto test = [&](const Proxy& other, Handle a) {
                if (!may_meet(other, proxy)) return;
                ++tests_;
                if (overlap(other.box, proxy.box)) pairs.push_back({a, first_moving() + b});
            };
            ++tests_;  // for its slabs
            index_.each_near(proxy.box, [&](Handle a) { test(still_[a], a); });
            for (Handle a = 0; a < b; ++a) test(moving[a], first_moving() + a);
        }
    }
    void find_overlapping(const SingleBox& box, std::vector<Handle>& found) override {
        tests_ += index_.find(box, found) + moving_.size();
        for (Handle i = 0; i < moving_.size(); ++i)
            if (overlap(box, moving_[i].box)) found.push_back(first_moving() + i);
    }
    [[nodiscard]] BroadPhaseFacts facts() const override { return {.name = "few"}; }
    void inspect(Inspector&) const override {}

  private:
    [[nodiscard]] Handle first_moving() const { return static_cast<Handle>(still_.size()); }

    std::vector<Proxy> still_;
    BoxIndex index_;  ///< of what is still
    std::span<const Proxy> moving_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_few(const std::vector<Proxy>& still, const Box& world) {
    return std::make_unique<Few>(still, world);
}

}  // namespace flipside::custom
