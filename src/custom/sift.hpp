#pragma once
/// Picking the few that matter out of many, where nothing foretells which. A branch that is guessed wrong
/// costs 15 to 20 cycles (Fog 2023, "The microarchitecture of Intel, AMD and VIA CPUs", 3), as much as a
/// dozen of the tests here; so every item is written, and the place is kept only where it passes.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "custom/broad_phase/room.hpp"
#include "custom/fetch.hpp"

namespace flipside::custom {

/// The places first … last − 1, to sift these.
struct Places {
    std::size_t first, last;
    [[nodiscard]] std::size_t size() const { return last - first; }
    std::uint32_t operator[](std::size_t i) const { return static_cast<std::uint32_t>(first + i); }
};

struct Nothing {
    void operator()(const auto&) const {}
};

inline constexpr std::size_t fetch_ahead = 64;  ///< items
inline constexpr std::size_t sift_block = 256;  ///< items

template <class T>
void make_writable(std::vector<T>& room, std::size_t size) {
    if (room.size() >= size) return;
    make_room(room, size);
    room.resize(size);
}

/// See sift(): of the items first … last − 1.
template <class T, class Prepare, class As>
[[nodiscard]] std::span<const T> sift_part(const auto& items, std::size_t first, std::size_t last,
                                           std::vector<T>& room, auto&& passes, const Prepare& prepare,
                                           const As& as) {
    make_writable(room, last - first);
    T* const kept = room.data();
    std::size_t count = 0;
    for (std::size_t i = first; i < last; ++i) {
        prepare(items[std::min(i + fetch_ahead, items.size() - 1)]);
        kept[count] = as(items[i]);
        count += static_cast<std::size_t>(passes(items[i]));
    }
    return {kept, count};
}

/// What passes of `items`, in order, written to `room`, which grows and never shrinks. `passes` must have no
/// branch of its own to be of use. `prepare` is called for each item a little before, to fetch what the test
/// will read; `as` makes of an item what is kept of it.
template <class T, class Prepare = Nothing, class As = std::identity>
[[nodiscard]] std::span<const T> sift(const auto& items, std::vector<T>& room, auto&& passes,
                                      const Prepare& prepare = {}, const As& as = {}) {
    return sift_part(items, 0, items.size(), room, passes, prepare, as);
}

/// Visits what passes, the survivors of a block of items together. So what the tests read is still at hand
/// then: what is done with a few has branches, and to wait for memory there costs most.
template <class T, class Prepare = Nothing>
void each_sifted(const auto& items, std::vector<T>& room, auto&& passes, auto&& visit,
                 const Prepare& prepare = {}) {
    for (std::size_t first = 0; first < items.size(); first += sift_block) {
        const std::size_t last = std::min(first + sift_block, items.size());
        visit(sift_part(items, first, last, room, passes, prepare, std::identity{}));
    }
}

/// What passes of a part of the items, told apart: what `is_first` says of each goes to `room` or else to
/// `other`.
template <class T, class Prepare = Nothing>
[[nodiscard]] std::pair<std::span<const T>, std::span<const T>> sift_apart(
    const auto& items, std::size_t first, std::size_t last, std::vector<T>& room, std::vector<T>& other,
    auto&& passes, auto&& is_first, const Prepare& prepare = {}) {
    make_writable(room, last - first);
    make_writable(other, last - first);
    T *const firsts = room.data(), *const others = other.data();
    std::size_t first_count = 0, other_count = 0;
    for (std::size_t i = first; i < last; ++i) {
        prepare(items[std::min(i + fetch_ahead, items.size() - 1)]);
        firsts[first_count] = others[other_count] = items[i];
        const auto passed = static_cast<std::size_t>(passes(items[i]));
        const auto is_one = static_cast<std::size_t>(is_first(items[i]));
        first_count += passed & is_one;
        other_count += passed & ~is_one;
    }
    return {{firsts, first_count}, {others, other_count}};
}

/// Where in `items`, in order, those end that come before: halved without a branch.
[[nodiscard]] std::size_t count_before(const auto& items, auto&& is_before) {
    std::size_t count = 0;
    for (std::size_t left = items.size(); left > 0;) {
        const std::size_t half = left - left / 2;
        count += is_before(items[count + half - 1]) ? half : 0;
        left -= half;
    }
    return count;
}

}  // namespace flipside::custom
