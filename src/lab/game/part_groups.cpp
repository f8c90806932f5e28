#include "lab/game/part_groups.hpp"

#include <algorithm>

namespace flipside::lab {

int PartGroups::count(const Rules::Group& group) const {
    return static_cast<int>(
        std::ranges::count_if(group.parts, [this](PartIndex part) { return hit_[part]; }));
}

void PartGroups::shift(const Rules::Group& group, Side side) {
    const std::vector<bool> before = hit_;
    for (std::size_t i = 0; i < group.parts.size(); ++i)
        hit_[group.parts[beside(i, group.parts.size(), side)]] = before[group.parts[i]];
}

}  // namespace flipside::lab
