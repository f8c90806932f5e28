#include "custom/broad_phase/pair_order.hpp"

#include <algorithm>
#include <numeric>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

void PairOrder::start(Handle first, std::size_t moving) {
    first_ = first;
    count_ = 0;
    make_room(found_, moving, pairs_per_ball);
    found_.resize(found_.capacity());
    make_room(end_, moving);
    end_.assign(moving, 0);
}

void PairOrder::finish(std::vector<Pair>& pairs) {
    const std::span<const Pair> found(found_.data(), count_);
    for (const Pair& pair : found) ++end_[pair.b - first_];
    // Where each one's pairs begin; filling them in moves that to where they end.
    std::exclusive_scan(end_.begin(), end_.end(), end_.begin(), 0U);
    make_room(pairs, found_.capacity());
    pairs.resize(count_);
    for (const Pair& pair : found) pairs[end_[pair.b - first_]++] = pair;
    auto begin = pairs.begin();
    for (const std::uint32_t end : end_) {
        const auto next = pairs.begin() + end;
        if (next - begin > 1) std::sort(begin, next);
        begin = next;
    }
}

}  // namespace flipside::custom
