#pragma once
/// Room in lists, so that a step allocates nothing while no balls join. What a step lists is bounded by
/// the number of balls and what one of them can be near to; the figures here hold for the densest heaps of
/// like balls with a part at every side, with room to spare.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace flipside::custom {

inline constexpr std::size_t pairs_per_ball = 16;    ///< listed as near, at rest
inline constexpr std::size_t contacts_per_ball = 8;  ///< boxes that overlap during one flight
inline constexpr std::size_t touches_per_ball = 4;
inline constexpr std::size_t events_per_ball = 32;  ///< in a step in which a heap lands
inline constexpr std::size_t least_room = 1024;     ///< for a few balls, however fast

inline constexpr std::size_t spare = 64;  ///< balls for which there is always room

/// Makes room for at least `count` items. It grows by doubling, so seldom.
template <class T>
void reserve_for(std::vector<T>& list, std::size_t count) {
    if (list.capacity() < count) list.reserve(std::bit_ceil(count + spare));
}
template <class T>
void reserve_for(std::vector<T>& list, std::size_t balls, std::size_t per_ball) {
    reserve_for(list, std::max(least_room, balls * per_ball));
}

}  // namespace flipside::custom
