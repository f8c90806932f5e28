#include "custom/broad_phase/near_list.hpp"

#include <algorithm>
#include <limits>

#include "custom/broad_phase/pair_order.hpp"
#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

void NearList::reserve(std::size_t moving, std::size_t balls) {
    make_room(rooms_, moving);
    make_room(leavers_, moving);
    strays_.reserve(moving);
    for (auto* list : {&listed_, &found_, &hits_}) make_room(*list, balls, pairs_per_ball);
    make_room(ball_hits_, sift_block);
    make_room(places_, balls, pairs_per_ball);
    make_room(around_, still_.size() + moving);
}

NearList::Check NearList::begin(std::size_t moving) {
    if (rooms_.size() != moving) {
        // Nothing fits into these.
        constexpr double far = std::numeric_limits<double>::infinity();
        rooms_.assign(moving, {{{far, far}, {-far, -far}}});
        leavers_.resize(moving);
        can_mend_ = false;
        searched_ = nullptr;  // with no proxy left, no leaver would cause the search
    }
    return {rooms_.data(), leavers_.data()};
}

void NearList::search(BroadPhase& broad) {
    broad.find_pairs(rooms_, listed_);
    searched_ = &broad;
    strays_.clear();
    can_mend_ = std::ranges::any_of(rooms_, &Proxy::active);
}

void NearList::find_around(const SingleBox& box, BroadPhase& broad, std::vector<Handle>& found) {
    broad.find_overlapping(box, found);
    const auto first = static_cast<Handle>(still_.size());
    tests_ += strays_.each_overlapping(box, [&](std::uint32_t stray) { found.push_back(first + stray); });
}

/// Adds the pairs of those that left. What is no longer near stays listed: it will be sifted out.
void NearList::mend(std::span<const std::uint32_t> leavers, BroadPhase& broad) {
    const auto first = static_cast<Handle>(still_.size());
    found_.clear();
    for (const std::uint32_t i : leavers) strays_.add(i, rooms_[i].box);
    const auto seek = [&](std::uint32_t i) {
        around_.clear();
        find_around(rooms_[i].box, broad, around_);
        for (const Handle other : around_) {
            const Proxy& proxy = other < first ? still_[other] : rooms_[other - first];
            if (other != first + i && may_meet(rooms_[i], proxy))
                found_.push_back({std::min(other, first + i), std::max(other, first + i)});
        }
    };
    const auto prepare = [&](std::uint32_t soon) { broad.prepare(rooms_[soon].box); };
    each_prepared(leavers, prepare, seek);
    add_pairs(found_, listed_, places_);
}

}  // namespace flipside::custom
