// Brute force: every moving proxy against every still one and every moving one before it.

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

class BruteForce final : public BroadPhase {
  public:
    explicit BruteForce(std::vector<Proxy> still) : still_(std::move(still)) {}

    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) override {
        pairs.clear();
        moving_ = moving;
        const auto first = static_cast<Handle>(still_.size());
        const auto count = static_cast<Handle>(moving.size());
        for (Handle b = 0; b < count; ++b) {
            for (Handle a = 0; a < first; ++a)
                if (test(still_[a], moving[b])) pairs.push_back({a, first + b});
            for (Handle a = 0; a < b; ++a)
                if (test(moving[a], moving[b])) pairs.push_back({first + a, first + b});
        }
    }
    void find_overlapping(const SingleBox& box, std::vector<Handle>& found) override {
        tests_ += still_.size() + moving_.size();
        for (Handle i = 0; i < still_.size(); ++i)
            if (overlap(box, still_[i].box)) found.push_back(i);
        for (Handle i = 0; i < moving_.size(); ++i)
            if (overlap(box, moving_[i].box)) found.push_back(static_cast<Handle>(still_.size()) + i);
    }
    [[nodiscard]] BroadPhaseFacts facts() const override { return {.name = "brute force"}; }
    void inspect(Inspector&) const override {}

  private:
    bool test(const Proxy& a, const Proxy& b) {
        if (!may_meet(a, b)) return false;
        ++tests_;
        return overlap(a.box, b.box);
    }

    std::vector<Proxy> still_;
    std::span<const Proxy> moving_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_brute_force(std::vector<Proxy> still) {
    return std::make_unique<BruteForce>(std::move(still));
}

}  // namespace flipside::custom
