#pragma once
/// Picking the few that matter out of many, where nothing foretells which. A branch that is guessed wrong
/// costs 15 to 20 cycles (Fog 2023, "The microarchitecture of Intel, AMD and VIA CPUs", 3), as much as a
/// dozen of the tests here; so every item is written, and the place is kept only where it passes.

#include <functional>
#include <span>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

/// What passes of `items`, in order, `as` something, written to `room`, which grows and never shrinks.
/// `passes` must have no branch of its own to be of use.
template <class T, class As>
[[nodiscard]] std::span<const T> sift(const auto& items, std::vector<T>& room, auto&& passes, As&& as) {
    if (room.size() < items.size()) {
        make_room(room, items.size());
        room.resize(items.size());
    }
    T* const kept = room.data();
    std::size_t count = 0;
    for (const auto& item : items) {
        kept[count] = as(item);
        count += static_cast<std::size_t>(passes(item));
    }
    return {kept, count};
}
template <class T>
[[nodiscard]] std::span<const T> sift(const auto& items, std::vector<T>& room, auto&& passes) {
    return sift(items, room, passes, std::identity{});
}

}  // namespace flipside::custom
