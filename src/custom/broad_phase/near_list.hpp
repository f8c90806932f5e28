#pragma once
/// Pairs that can meet soon, sought with room to spare so that one search of the broad phase serves many
/// flights (Verlet 1967, "Computer experiments on classical fluids"). What it answers is what the broad
/// phase itself would: the room changes the cost, never the outcome.

#include <cstdint>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

class NearList {
  public:
    /// Keeps a reference to the still proxies.
    explicit NearList(const std::vector<Proxy>& still) : still_(still) {}

    /// Every pair whose boxes overlap now and that may meet, as BroadPhase::find_pairs() finds them. When a
    /// proxy has left the room that it had in the last search, or is active and was not then, searches
    /// anew, each proxy i in the box `roomy(i)`, which must hold its box of now.
    /// Cost: one box test per listed pair, unless it searches.
    void find_pairs(std::span<const Proxy> moving, BroadPhase& broad, auto&& roomy,
                    std::vector<Pair>& pairs) {
        if (!holds(moving)) {
            make_room(room_, moving.size());
            room_.assign(moving.begin(), moving.end());
            for (std::size_t i = 0; i < moving.size(); ++i) room_[i].box = roomy(i);
            broad.find_pairs(room_, listed_);
        }
        sift(moving, pairs);
    }
    /// The same, but searches without room when it must.
    void find_pairs(std::span<const Proxy> moving, BroadPhase& broad, std::vector<Pair>& pairs) {
        if (holds(moving))
            sift(moving, pairs);
        else
            broad.find_pairs(moving, pairs);
    }

    /// Box in which the list holds for a moving proxy.
    [[nodiscard]] const Box& room(std::size_t moving) const { return room_[moving].box; }
    /// The listed pairs whose later proxy is this moving one.
    [[nodiscard]] std::span<const Pair> listed(std::size_t moving) const;
    /// Box tests by sifting since the start.
    [[nodiscard]] std::uint64_t tests() const { return tests_; }

  private:
    [[nodiscard]] bool holds(std::span<const Proxy> moving) const;
    void sift(std::span<const Proxy> moving, std::vector<Pair>& pairs);

    const std::vector<Proxy>& still_;
    std::vector<Proxy> room_;
    std::vector<Pair> listed_;
    std::uint64_t tests_ = 0;
};

}  // namespace flipside::custom
