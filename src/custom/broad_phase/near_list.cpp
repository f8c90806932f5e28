#include "custom/broad_phase/near_list.hpp"

#include <algorithm>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

bool NearList::holds(std::span<const Proxy> moving) const {
    return std::ranges::equal(moving, room_, [](const Proxy& now, const Proxy& room) {
        return room.box.contains(now.box.min) && room.box.contains(now.box.max) &&
               room.active >= now.active && room.ball == now.ball && room.layer == now.layer &&
               room.collides_with == now.collides_with;
    });
}

void NearList::sift(std::span<const Proxy> moving, std::vector<Pair>& pairs) {
    pairs.clear();
    make_room(pairs, listed_.capacity());
    const auto first = static_cast<Handle>(still_.size());
    for (const Pair pair : listed_) {
        const Proxy& a = pair.a < first ? still_[pair.a] : moving[pair.a - first];
        const Proxy& b = moving[pair.b - first];
        if (!a.active && !b.active) continue;
        ++tests_;
        if (overlap(a.box, b.box)) pairs.push_back(pair);
    }
}

std::span<const Pair> NearList::listed(std::size_t moving) const {
    const auto handle = static_cast<Handle>(still_.size() + moving);
    return {std::ranges::lower_bound(listed_, handle, {}, &Pair::b),
            std::ranges::upper_bound(listed_, handle, {}, &Pair::b)};
}

}  // namespace flipside::custom
