// Every pair is tested. Cost: O(n · (still + n)) tests, nothing kept between searches.

#include <algorithm>

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

class BruteForce final : public BroadPhase {
  public:
    explicit BruteForce(std::vector<Proxy> still) : still_(std::move(still)) {}

    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) override {
        pairs.clear();
        const auto first_moving = static_cast<Handle>(still_.size());
        for (Handle i = 0; i < moving.size(); ++i) {
            const auto test = [&](const Proxy& other, Handle handle) {
                if (!may_meet(other, moving[i])) return;
                ++tests_;
                if (overlap(other.box, moving[i].box)) pairs.push_back({handle, first_moving + i});
            };
            for (Handle j = 0; j < first_moving; ++j) test(still_[j], j);
            for (Handle j = 0; j < i; ++j) test(moving[j], first_moving + j);
        }
    }
    [[nodiscard]] BroadPhaseFacts facts() const override { return {.name = "brute force"}; }
    void inspect(Inspector&) const override {}

  private:
    std::vector<Proxy> still_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_brute_force(std::vector<Proxy> still) {
    return std::make_unique<BruteForce>(std::move(still));
}

}  // namespace flipside::custom
