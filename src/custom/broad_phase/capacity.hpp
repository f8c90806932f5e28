#pragma once
/// Capacities of lists, so that a step allocates nothing unless balls are added. The number of entries is
/// bounded by the number of balls and of their neighbours; the figures hold for the densest heaps of equal
/// balls with parts on all sides, with a reserve.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace flipside::custom {

inline constexpr std::size_t pairs_per_ball = 16;    ///< candidate pairs of a ball at rest
inline constexpr std::size_t contacts_per_ball = 8;  ///< contacts and forces of a ball
inline constexpr std::size_t touches_per_ball = 4;
inline constexpr std::size_t most_near = 512;        ///< features near one ball
inline constexpr std::size_t events_per_ball = 64;   ///< in a step in which a heap lands
inline constexpr std::size_t least_capacity = 1024;  ///< for a few balls of any speed

inline constexpr std::size_t spare = 64;  ///< balls that may be added without an allocation

/// Reserves at least `count` items. Capacities double, so they grow seldom.
template <class T>
void reserve_for(std::vector<T>& list, std::size_t count) {
    if (list.capacity() < count) list.reserve(std::bit_ceil(count + spare));
}
template <class T>
void reserve_for(std::vector<T>& list, std::size_t balls, std::size_t per_ball) {
    if (list.capacity() < std::max(least_capacity, balls * per_ball))
        list.reserve(std::bit_ceil(std::max(least_capacity, (balls + spare) * per_ball)));
}

}  // namespace flipside::custom
