#pragma once
/// Predicts the next event of each ball, and keeps them in a queue.

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "custom/continuous/gates.hpp"
#include "custom/continuous/paths.hpp"
#include "custom/continuous/simulation.hpp"

namespace flipside::custom {

/// The next event of every ball, in a tournament tree whose root is the earliest event (Knuth, "The Art of
/// Computer Programming", vol. 3, 5.4.1). A match is replayed only when one of its players has changed.
/// Events at the same time are ordered by their `order`. Cost: log₂ n matches per change. Only events whose
/// other ball has changed its path are outdated.
class EventQueue {
  public:
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

class Predictions {
  public:
    Predictions(Simulation& sim, Gates& gates, Paths& paths) : sim_(sim), gates_(gates), paths_(paths) {}

    void reserve(std::size_t balls) { queue_.reserve(balls); }
    /// Starts a window: no ball has a next event.
    void clear() { queue_.reset(sim_.balls.size()), batch_ = 0; }
    [[nodiscard]] const EventQueue& queue() const { return queue_; }

    /// Predicts the next event of a ball on its path.
    void predict(BallIndex i, double time) { predict(std::span(&i, 1), time); }
    /// The same for several balls whose paths all start now. Each pair of them is predicted once.
    void predict(std::span<const BallIndex> balls, double time);
    /// Lists a ball in the cell in which it is now, and predicts its events with the neighbours there.
    void enter_cell(BallIndex i);
    /// A lost ball has no events.
    void forget(BallIndex i) { queue_.set(i, INFINITY, 0); }

  private:
    /// Order of events at the same time, whichever ball predicted them: first those without a second ball,
    /// then by the lower ball, then by the higher.
    [[nodiscard]] static std::uint64_t order_of(BallIndex i, EventType next, std::uint32_t partner);
    void predict_in_batch(BallIndex i, double time);
    void predict_features(BallIndex i, double time, Vec2 from);
    void predict_sensors(BallIndex i, double time, std::span<const FeatureIndex> near);
    void predict_ball(BallIndex i, BallIndex j, double time);
    void predict_flying(BallIndex i, BallIndex j, double time);
    void predict_loss(BallIndex i, double time);
    [[nodiscard]] bool slides_to(const Particle& particle, const Ball& ball, const Feature& feature) const;
    [[nodiscard]] bool in_slow_contact(BallIndex i, BallIndex j, double time) const;
    /// Where a search for an event of the ball ends: what is later comes after an event that is predicted so
    /// far, or after the ball has left its cell, and is searched then.
    [[nodiscard]] double search_end(const Particle& particle) const;
    [[nodiscard]] bool rests_on(BallIndex i, const Feature& feature, const Pose& pose, double time) const;
    void note_near(BallIndex i, BallIndex j, double until, double from);
    void offer(BallIndex i, double time, EventType next, std::uint32_t partner = 0,
               std::uint32_t partner_version = 0) const;
    void schedule(BallIndex i);

    Simulation& sim_;
    Gates& gates_;
    Paths& paths_;
    EventQueue queue_;
    std::uint32_t batch_ = 0;  ///< number of the current batch in this window
};

}  // namespace flipside::custom
