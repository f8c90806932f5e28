#pragma once
/// Steps of the continuous solver. The solver works in windows of a quarter of a second, whose ends lie on a
/// grid of the world's time; a step runs the solver to its end and reads the balls there. So the result does
/// not depend on the steps, to the bit. A window begins at the end of the previous one, or when something
/// outside the solver has changed the world.
///
/// A ball falls asleep at the end of a window if it was at rest in the last sixtieth of a second; a sleeping
/// ball that has lost a support wakes there, and so does one beside a ball that moves. If all balls sleep and
/// no part moves, the world is quiet, and a step costs nothing per ball.

#include <memory>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/continuous/continuous_solver.hpp"
#include "custom/islands/sleep.hpp"
#include "custom/touch_list.hpp"

namespace flipside::custom {

class Windows {
  public:
    /// Keeps references to all but the settings. `broad` finds the contacts at the start of a window that
    /// does not follow on another.
    Windows(Table& table, const Layout& layout, BroadPhase& broad, const SolverSettings& settings);

    /// Reserves memory for so many balls.
    void reserve(std::size_t balls);
    /// Moves clock, parts and balls by dt.
    void step(double dt, std::vector<Ball>& balls, StepRecord& record);
    /// Ends the window here, after something outside the solver has changed balls or parts, or added balls.
    void interrupt() { in_window_ = quiet_ = contacts_known_ = false; }
    /// The same after balls were removed or replaced; clears all that the solver holds of them.
    void begin_anew() { interrupt(), balls_known_ = false; }
    /// Whether nothing moves until interrupt().
    [[nodiscard]] bool quiet() const { return quiet_; }
    /// Whether a ball fell asleep in the last step.
    [[nodiscard]] bool fell_asleep() const { return fell_asleep_; }

    /// State at the start of the current window, which leads to the present state; null between windows.
    [[nodiscard]] std::shared_ptr<const State> origin() const;
    /// Keeps the current window for kept_origin(), until the next call.
    void keep();
    [[nodiscard]] std::shared_ptr<const State> kept_origin() const;
    /// Runs the window that begins at the state's origin, which is loaded already, up to the state. Returns
    /// false if that does not lead to the state: another engine wrote it, or it was changed.
    bool resume(const State& state, std::vector<Ball>& balls, StepRecord& record);

    /// Pairs of overlapping boxes, as a broad phase gives them; `balls` as they are after the last step.
    [[nodiscard]] std::span<const Pair> find_pairs(std::span<const Ball> balls) {
        return solver_.find_pairs(balls);
    }
    void inspect_cells(Inspector& inspector) const { solver_.inspect_cells(inspector); }

  private:
    void advance_to(const Clock& now, std::vector<Ball>& balls, StepRecord& record);
    void begin(std::vector<Ball>& balls, StepRecord& record);
    void end_window(std::vector<Ball>& balls);

    Table& table_;
    const Layout& layout_;
    BroadPhase& broad_;
    SolverSettings settings_;
    ContinuousSolver solver_;
    Sleep sleep_;
    TouchList contacts_;           ///< at the start of the window
    bool contacts_known_ = false;  ///< contacts_ is up to date
    bool balls_known_ = false;     ///< the solver has data on them from the previous window
    bool in_window_ = false;
    bool quiet_ = false;
    bool fell_asleep_ = false;
    bool watched_ = false;              ///< sleep_.watch() has been called in this window
    double watch_at_ = 0, end_at_ = 0;  ///< s: when to call sleep_.watch(), and the end of the window
    bool kept_in_window_ = false;
};

}  // namespace flipside::custom
