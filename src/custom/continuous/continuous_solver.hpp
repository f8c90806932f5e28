#pragma once
/// The continuous solver: event-driven molecular dynamics (Alder and Wainwright 1959; Lubachevsky 1991, "How
/// to simulate billiards and similar systems"). Every ball follows its exact path to its next event. Events
/// are handled in order of time, and only the balls involved are predicted again. The only error is rounding;
/// none grows with dt.
///
/// The solver works in windows of a quarter of a second, whose ends lie on a grid of the world's time. All
/// balls start a new path at the start of a window; a step handles the events up to its end and reads the
/// balls off their paths. So the result does not depend on the steps, to the bit. A window begins at the end
/// of the previous one, or when something outside the solver has changed the world. Resting contacts follow
/// from positions and velocities at the start, so a window can be repeated from the state of the world there.
///
/// A ball falls asleep at the end of a window if it was at rest in the last twentieth of a second
/// (sleep.hpp); a sleeping ball that has lost a support wakes there, and so does one beside a ball that
/// moves. If all balls sleep and no part moves, the world is quiet, and a step costs nothing per ball.
///
/// Cells (neighbours.hpp) find neighbours. A ball that changes its cell queries the cells that are new beside
/// it. Of each ball only the next event is kept (next_events.hpp). If the partner of that event has changed
/// its path meanwhile, the ball is predicted again.
///
/// A slow contact with a part becomes a resting contact (resting_contact.hpp): slow is an approach below
/// rest_speed, or a bounce too short to matter. Balls in resting contact with each other are members of
/// contact islands (islands.hpp), where the result is not exact, but does not depend on the steps either.

#include <memory>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/continuous/events.hpp"
#include "custom/islands/sleep.hpp"

namespace flipside::custom {

class ContinuousSolver {
  public:
    /// Keeps references to all but the settings. `broad` finds the contacts at the start of a window that
    /// does not follow on another.
    ContinuousSolver(Table& table, const Layout& layout, BroadPhase& broad, const SolverSettings& settings);

    void reserve(std::size_t balls);
    /// Takes over what the table's state tells of these balls. Unless this engine saved it at this time,
    /// finds which of them are in sensors; balls that come later enter them.
    void load(std::span<const Ball> balls);
    /// Moves clock, parts and balls by dt.
    void step(double dt, std::vector<Ball>& balls, StepRecord& record);
    /// Ends the window here, after something outside the solver has changed balls or parts, or added balls.
    void interrupt() { in_window_ = quiet_ = contacts_known_ = false; }
    /// Whether nothing moves until interrupt(): all balls sleep and no part moves.
    [[nodiscard]] bool quiet() const { return quiet_; }
    /// Whether a ball fell asleep or woke at the end of a window in the last step. find_pairs() then lacks
    /// pairs.
    [[nodiscard]] bool sleep_changed() const { return sleep_changed_; }

    /// State at the start of the current window, which leads to the present state; null between windows.
    [[nodiscard]] std::shared_ptr<const State> origin() const;
    /// Keeps the current window for kept_origin(), until the next call.
    void keep();
    [[nodiscard]] std::shared_ptr<const State> kept_origin() const;
    /// Whether the state before the next step follows from kept_origin(), or differs from that after it by
    /// time alone.
    [[nodiscard]] bool can_undo() const { return in_window_ || quiet_; }
    /// Runs the window that begins with the state that is loaded up to a time in it. Returns false if that is
    /// no time of the window, or is never reached.
    bool resume(const Clock& to, std::vector<Ball>& balls, StepRecord& record);

    /// Pairs whose boxes overlap and which contain an awake ball, in no particular order; `balls` are those
    /// after the last step.
    [[nodiscard]] std::span<const Pair> find_pairs(std::span<const Ball> balls);
    /// Draws the cells.
    void inspect_cells(Inspector& inspector) const { sim_.cells.inspect(inspector); }

  private:
    void advance_to(const Clock& now, std::vector<Ball>& balls);
    void begin(const std::vector<Ball>& balls);
    void choose_end();
    void start_all_paths();
    void handle_until(double time);
    void read(double time, std::vector<Ball>& balls);
    void end(std::vector<Ball>& balls);
    void pair_with_parts(std::span<const Ball> balls, BallIndex i, double time);
    void pair_with_balls(std::span<const Ball> balls, BallIndex i);

    // Each knows only those before it.
    Simulation sim_;
    Gates gates_;
    Paths paths_;
    Predictions predictions_;
    Islands islands_;
    Events events_;

    Sleep sleep_;

    // The current window.
    bool in_window_ = false, quiet_ = false;
    double end_on_clock_ = 0;  ///< its end on the table's clock, s
    double watch_at_ = 0;      ///< s, on the table's clock: when to call sleep_.watch(); INFINITY if no more

    // Kept from window to window.
    bool contacts_known_ = false;  ///< contacts_ is up to date
    TouchList contacts_;           ///< at the start of the window
    bool sleep_changed_ = false;
    std::array<State, 2> starts_;  ///< of the current window, and of the one that is kept
    std::size_t current_ = 0, kept_ = 0;
    bool kept_in_window_ = false;

    // Buffers, kept to save allocations.
    std::vector<BallIndex> awake_;
    std::vector<BallIndex> rank_;  ///< per ball: index among those of the last read()
    std::vector<Pair> pairs_;
};

}  // namespace flipside::custom
