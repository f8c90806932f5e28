#pragma once
/// Tells the processor what will be read soon: what lies anywhere in memory takes a hundred times longer to
/// come than what lies next. Only a few dozen lines of the cache can be on their way at once, so nothing is
/// asked for that will not be read.

#include <algorithm>
#include <cstddef>

#include "world/ball.hpp"

namespace flipside::custom {

/// All of a thing of at most two lines.
template <class T>
void fetch(const T& thing) {
    const auto* bytes = reinterpret_cast<const char*>(&thing);
    __builtin_prefetch(bytes);
    constexpr std::size_t size = sizeof(T), alignment = alignof(T);
    if constexpr (alignment < size) __builtin_prefetch(bytes + size - 1);  // maybe another line
}

/// Where a ball is and how it moves: its first members, as far as `asleep`.
inline void fetch_motion(const Ball& ball) {
    fetch(ball.position.x);
    fetch(ball.asleep);
}

/// That and how it turns: as far as `spin`.
inline void fetch_flight(const Ball& ball) {
    fetch(ball.position.x);
    fetch(ball.spin);
}

/// Visits all. What a visit reads lies anywhere in memory: `prepare` is called before, to fetch it.
void each_prepared(const auto& items, const auto& prepare, auto&& visit) {
    constexpr std::size_t ahead = 24;
    for (std::size_t i = 0; i < std::min(ahead, items.size()); ++i) prepare(items[i]);
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i + ahead < items.size()) prepare(items[i + ahead]);
        visit(items[i]);
    }
}

}  // namespace flipside::custom
