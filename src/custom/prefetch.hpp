#pragma once
/// Asks the processor to load an object into its cache while it works on others. It changes no result, and
/// pays where so many balls are simulated that their data does not fit there.

#include <cstddef>

namespace flipside::custom {

/// Inlined always, since GCC removes calls of functions that do nothing but this.
template <class T>
[[gnu::always_inline]] inline void prefetch(const T& object) {
    constexpr std::size_t cache_line = 64;  // bytes
    const auto* bytes = static_cast<const char*>(static_cast<const void*>(&object));
    for (std::size_t at = 0; at < sizeof(T); at += cache_line) __builtin_prefetch(bytes + at);
}

}  // namespace flipside::custom
