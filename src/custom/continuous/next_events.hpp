#pragma once
/// The next event of every ball, and which of them comes first: a tournament in which each match is won by
/// the earlier event and is played again only when one of its players has changed (Knuth, "The Art of
/// Computer Programming", vol. 3, 5.4.1). Events at the same time are ordered by a number that says what
/// they are. Cost: log₂ n matches per change; nothing stale is ever kept.

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace flipside::custom {

class NextEvents {
  public:
    using BallIndex = std::uint32_t;

    void reserve(std::size_t balls) {
        const std::size_t players = std::bit_ceil(balls + 1);
        events_.reserve(players);
        winners_.reserve(players);
    }
    /// So many balls, none of which has an event.
    void reset(std::size_t balls) {
        const std::size_t players = std::bit_ceil(balls < 2 ? 2 : balls);
        events_.assign(players, {});
        winners_.resize(players);
        for (std::size_t match = players; --match > 0;) winners_[match] = winner_of(2 * match);
    }
    /// The next event of a ball is at this time; INFINITY if it has none.
    void set(BallIndex i, double time, std::uint64_t order) {
        events_[i] = {time, order};
        for (std::size_t match = (events_.size() + i) / 2; match > 0; match /= 2) {
            const BallIndex winner = winner_of(2 * match);
            if (winner != i && winner == winners_[match]) return;  // won, and wins on, against i
            winners_[match] = winner;
        }
    }
    /// Whose event comes first; its time is time().
    [[nodiscard]] BallIndex first() const { return winners_[1]; }
    [[nodiscard]] double time() const { return events_[winners_[1]].time; }

  private:
    struct Event {
        double time = INFINITY;
        std::uint64_t order = ~std::uint64_t{0};
    };
    [[nodiscard]] BallIndex player(std::size_t node) const {
        return node >= events_.size() ? static_cast<BallIndex>(node - events_.size()) : winners_[node];
    }
    /// Of the match between a node and the one beside it.
    [[nodiscard]] BallIndex winner_of(std::size_t node) const {
        const BallIndex a = player(node), b = player(node + 1);
        const Event &x = events_[a], &y = events_[b];
        if (x.time != y.time) return x.time < y.time ? a : b;
        return x.order <= y.order ? a : b;
    }

    std::vector<Event> events_;       ///< by place, a power of two of them
    std::vector<BallIndex> winners_;  ///< of each match; node k plays under node k/2
};

}  // namespace flipside::custom
