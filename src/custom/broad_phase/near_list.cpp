#include "custom/broad_phase/near_list.hpp"

#include <algorithm>
#include <limits>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

void NearList::reserve(std::size_t moving, std::size_t balls) {
    make_room(rooms_, moving);
    for (auto* list : {&leavers_, &strays_}) make_room(*list, moving, 1);
    for (auto* list : {&listed_, &found_, &hits_}) make_room(*list, balls, pairs_per_ball);
    make_room(around_, still_.size() + moving);
}

void NearList::recognise(std::span<const Proxy> moving) {
    const bool same = std::ranges::equal(moving, rooms_, [](const Proxy& now, const Proxy& room) {
        return (room.ball == now.ball) & (room.layer == now.layer) &
               (room.collides_with == now.collides_with);
    });
    if (same) return;
    // Nothing fits into these.
    constexpr double far = std::numeric_limits<double>::infinity();
    rooms_.assign(moving.size(), {{{far, far}, {-far, -far}}});
    can_mend_ = false;
}

void NearList::search(BroadPhase& broad) {
    broad.find_pairs(rooms_, listed_);
    strays_.clear();
    can_mend_ = std::ranges::any_of(rooms_, &Proxy::active);
}

/// Adds the pairs of those that left. What is no longer near stays listed: it will be sifted out.
void NearList::mend(BroadPhase& broad) {
    const auto first = static_cast<Handle>(still_.size());
    found_.clear();
    for (const std::uint32_t i : leavers_) {
        const auto meet = [&](Handle other, const Proxy& proxy) {
            if (other == first + i || !may_meet(rooms_[i], proxy)) return;
            found_.push_back({std::min(other, first + i), std::max(other, first + i)});
        };
        around_.clear();
        broad.find_overlapping(rooms_[i].box, around_);
        for (const Handle other : around_) meet(other, other < first ? still_[other] : rooms_[other - first]);
        for (const std::uint32_t stray : strays_) {
            ++tests_;
            if (overlap(rooms_[i].box, rooms_[stray].box)) meet(first + stray, rooms_[stray]);
        }
        strays_.push_back(i);
    }
    std::ranges::sort(found_);
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    // Merged from the end, in place.
    auto old = listed_.size(), fresh = found_.size();
    listed_.resize(old + fresh);
    for (auto to = listed_.size(); fresh > 0;)
        listed_[--to] = old > 0 && found_[fresh - 1] < listed_[old - 1] ? listed_[--old] : found_[--fresh];
    listed_.erase(std::unique(listed_.begin(), listed_.end()), listed_.end());
}

}  // namespace flipside::custom
