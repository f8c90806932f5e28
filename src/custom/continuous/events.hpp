#pragma once
/// Handles the events of balls: impacts, ends of paths, sensors, gates, and the loss of a ball. Afterwards
/// only the balls involved have new paths and are predicted again.

#include <vector>

#include "custom/continuous/gates.hpp"
#include "custom/continuous/next_events.hpp"
#include "custom/continuous/paths.hpp"
#include "custom/continuous/simulation.hpp"
#include "custom/islands/islands.hpp"
#include "custom/response.hpp"

namespace flipside::custom {

class Events {
  public:
    Events(Simulation& sim, Gates& gates, Paths& paths, Predictions& predictions, Islands& islands)
        : sim_(sim), gates_(gates), paths_(paths), predictions_(predictions), islands_(islands) {}

    void reserve(std::size_t balls);
    /// Starts a window.
    void clear() { handled_ = 0; }
    /// Handles the next event of a ball.
    void handle(BallIndex i);

  private:
    [[nodiscard]] bool count_event(Particle& particle, double time, bool with_ball) const;
    void hit_feature(BallIndex i, double time);
    void hit_ball(BallIndex i, double time);
    [[nodiscard]] bool collide(BallIndex low, BallIndex high, double rest_speed, double time);
    void restart(BallIndex i, double time);
    void release(PartIndex part, BallIndex hitting, double time);
    void wake_carried(BallIndex i, double time);
    void lose(BallIndex i, double time);
    void enter_or_leave(BallIndex i, PartIndex part, double time);
    [[nodiscard]] bool meet_gate(BallIndex i, PartIndex part, double time);
    void leave_gate(BallNumber ball, PartIndex part, double time);
    void report(double time, EventKind kind, const Ball& ball, Other other, const Impact& impact, Vec2 point);
    [[nodiscard]] bool is_significant(const Impact& impact, const Ball& ball) const;

    Simulation& sim_;
    Gates& gates_;
    Paths& paths_;
    Predictions& predictions_;
    Islands& islands_;
    std::uint64_t handled_ = 0;     ///< events in this window
    std::vector<BallIndex> woken_;  ///< by the current event
};

}  // namespace flipside::custom
