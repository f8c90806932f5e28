#pragma once
/// Lanes and targets: which parts were hit, and which groups are complete.

#include <vector>

#include "world/scene.hpp"

namespace flipside::lab {

class PartGroups {
  public:
    explicit PartGroups(std::size_t parts) : hit_(parts) {}

    /// True where it was not hit since its group's last reset.
    bool hit(PartIndex part) {
        const bool first = !hit_[part];
        hit_[part] = true;
        return first;
    }
    void mark(PartIndex part) { hit_[part] = true; }
    [[nodiscard]] bool is_hit(PartIndex part) const { return hit_[part]; }
    [[nodiscard]] int count(const Rules::Group& group) const;
    [[nodiscard]] bool is_complete(const Rules::Group& group) const {
        return count(group) == static_cast<int>(group.parts.size());
    }
    void reset(const Rules::Group& group) {
        for (const PartIndex part : group.parts) hit_[part] = false;
    }
    /// The lights of a group move on by one place towards that side, round its end.
    void shift(const Rules::Group& group, Side side);

  private:
    std::vector<bool> hit_;  ///< per part: a lane that is lit, a target that is down
};

/// The place beside `place` among `count`, round their ends.
[[nodiscard]] constexpr std::size_t beside(std::size_t place, std::size_t count, Side side) {
    return (place + (side == Side::right ? 1 : count - 1)) % count;
}

}  // namespace flipside::lab
