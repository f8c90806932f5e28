#pragma once
/// Which balls and parts touch each other.

#include <set>
#include <utility>

#include "world/world.hpp"

namespace flipside {

using Pairs = std::set<std::pair<BallNumber, Other>>;

inline Pairs touching(const World& world) {
    Pairs pairs;
    for (const Contact& contact : world.contacts()) pairs.insert({contact.ball, contact.other});
    return pairs;
}

}  // namespace flipside
