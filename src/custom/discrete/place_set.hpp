#pragma once
/// A set of places in a list. A bit each: in order without being sorted, and none of them twice.

#include <bit>
#include <cstdint>
#include <vector>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

class PlaceSet {
  public:
    /// Makes room for the places 0 … places − 1.
    void reserve(std::size_t places) { make_room(words_, words(places)); }
    /// Empty, of the places 0 … places − 1.
    void start(std::size_t places) { words_.assign(words(places), 0); }
    void add(std::uint32_t place) { words_[place / bits] |= std::uint64_t{1} << place % bits; }
    /// Replaces `places` by those in the set, by rising place.
    /// Cost: O(places / 64 + those in the set).
    void list(std::vector<std::uint32_t>& places) const {
        places.clear();
        std::uint32_t first = 0;
        for (std::uint64_t word : words_) {
            for (; word != 0; word &= word - 1)
                places.push_back(first + static_cast<std::uint32_t>(std::countr_zero(word)));
            first += bits;
        }
    }

  private:
    static constexpr std::uint32_t bits = 64;
    static std::size_t words(std::size_t places) { return (places + bits - 1) / bits; }

    std::vector<std::uint64_t> words_;
};

}  // namespace flipside::custom
