// Every pair is tested. Cost: O(n · (still + n)) tests, nothing kept between searches.

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
            const Handle b = first_moving + i;
            for (Handle a = 0; a < first_moving; ++a) test(a, still_[a], b, moving[i], pairs);
            for (Handle j = 0; j < i; ++j) test(first_moving + j, moving[j], b, moving[i], pairs);
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
