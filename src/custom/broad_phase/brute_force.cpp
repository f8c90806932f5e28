// Brute force tests every pair. Cost: O(n · (still + n)) tests; it keeps nothing between searches.

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

class BruteForce final : public BroadPhase {
  public:
    using BroadPhase::BroadPhase;

    [[nodiscard]] BroadPhaseFacts facts() const override { return {.name = "brute force"}; }

  private:
    void search() override {
        for (Handle b = first_moving_; b < proxies_.size(); ++b)
            for (Handle a = 0; a < b; ++a) test(a, b);
    }
};

}  // namespace

std::unique_ptr<BroadPhase> make_brute_force(std::vector<Proxy> still, const BroadPhaseOptions&) {
    return std::make_unique<BruteForce>(std::move(still));
}

}  // namespace flipside::custom
