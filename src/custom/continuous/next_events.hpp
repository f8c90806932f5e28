#pragma once
/// Event queue: the next event of every ball, in a tournament tree whose root is the earliest event (Knuth,
/// "The Art of Computer Programming", vol. 3, 5.4.1). A match is replayed only when one of its players has
/// changed. Events at the same time are ordered by their `order`. Cost: log₂ n matches per change; the queue
/// holds no outdated events.

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
    /// Starts with so many balls without events.
    void reset(std::size_t balls) {
        const std::size_t players = std::bit_ceil(balls < 2 ? 2 : balls);
        events_.assign(players, {});
        winners_.resize(players);
        for (std::size_t match = players; --match > 0;) winners_[match] = winner_of(2 * match);
        soon_ = 0;
    }
    /// Sets the time of a ball's next event, INFINITY for none.
    void set(BallIndex i, double time, std::uint64_t order) {
        events_[i] = {time, order};
        for (std::size_t match = (events_.size() + i) / 2; match > 0; match /= 2) {
            const BallIndex winner = winner_of(2 * match);
            if (winner != i && winner == winners_[match]) return;  // the winner above does not change either
            winners_[match] = winner;
            if (match / groups == 1) soon_ = winner;
        }
    }
    /// The ball with the earliest event, which is at time().
    [[nodiscard]] BallIndex first() const { return winners_[1]; }
    [[nodiscard]] double time() const { return events_[winners_[1]].time; }
    /// The ball that most recently became the earliest of its sixteenth of all balls. Every ball is this one
    /// before it is first(), mostly some events earlier.
    [[nodiscard]] BallIndex soon() const { return soon_; }

  private:
    static constexpr std::size_t groups = 16;  ///< of all balls
    struct Event {
        double time = INFINITY;
        std::uint64_t order = ~std::uint64_t{0};
    };
    [[nodiscard]] BallIndex player(std::size_t node) const {
        return node >= events_.size() ? static_cast<BallIndex>(node - events_.size()) : winners_[node];
    }
    /// Winner of the match between a node and its sibling.
    [[nodiscard]] BallIndex winner_of(std::size_t node) const {
        const BallIndex a = player(node), b = player(node + 1);
        const Event &x = events_[a], &y = events_[b];
        if (x.time != y.time) return x.time < y.time ? a : b;
        return x.order <= y.order ? a : b;
    }

    std::vector<Event> events_;       ///< per ball, a power of two of them
    std::vector<BallIndex> winners_;  ///< of each match; node k plays under node k/2
    BallIndex soon_ = 0;
};

}  // namespace flipside::custom
