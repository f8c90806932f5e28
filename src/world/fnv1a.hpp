#pragma once
/// FNV-1a, 64 bits (Fowler, Noll and Vo, 1991): a hash that is short to compute and the same everywhere.

#include <cstdint>
#include <string_view>

namespace flipside {

/// Goes on from `hash`, that of the bytes before these.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 0xcbf29ce484222325) {
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    return hash;
}

}  // namespace flipside
