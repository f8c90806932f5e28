#pragma once
/// Steps with the continuous solver. It works in windows of a quarter of a second, whose ends lie on a grid
/// of the world's time; a step runs it on and reads the balls there. So the outcome does not depend on the
/// steps, to the bit. A window begins where the last one ended, or where something from outside has changed
/// the world.
///
/// Balls fall asleep at the end of a window, when they were at rest in its last sixtieth of a second; what
/// sleeps and has lost a contact from below wakes there. Where all balls sleep and no part moves the world is
/// quiet: a step then costs nothing per ball.

#include <memory>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/continuous/continuous_solver.hpp"
#include "custom/islands/sleep.hpp"
#include "custom/touch_list.hpp"

namespace flipside::custom {

class Windows {
  public:
    /// Keeps references to all but the settings. `broad` finds contacts where a window begins otherwise than
    /// at the end of another.
    Windows(Table& table, const Layout& layout, BroadPhase& broad, const SolverSettings& settings);

    /// Makes room for so many balls.
    void reserve(std::size_t balls);
    /// Moves clock, parts and balls by dt.
    void step(double dt, std::vector<Ball>& balls, StepRecord& record);
    /// Something from outside has changed balls or parts, or balls were added: the window ends here.
    void interrupt() { in_window_ = quiet_ = contacts_known_ = false; }
    /// Balls were removed or replaced: what is known of them is found anew.
    void begin_anew() { interrupt(), balls_known_ = false; }
    /// Nothing moves until interrupt().
    [[nodiscard]] bool quiet() const { return quiet_; }
    /// Whether any ball did in the last step.
    [[nodiscard]] bool fell_asleep() const { return fell_asleep_; }

    /// The start of the window under way, from which its balls came to where they are; null between windows.
    [[nodiscard]] std::shared_ptr<const State> origin() const;
    /// Remembers the window under way, for kept_origin() until the next call.
    void keep();
    [[nodiscard]] std::shared_ptr<const State> kept_origin() const;
    /// After the state's origin was loaded: goes on to the state, within the window that begins there. False
    /// where that does not lead to it: it is another engine's, or was changed.
    bool resume(const State& state, std::vector<Ball>& balls, StepRecord& record);

    /// Pairs of parts and awake balls that are near each other, as a broad phase gives them; `balls` as they
    /// are after the last step.
    [[nodiscard]] std::span<const Pair> find_pairs(std::span<const Ball> balls) {
        return solver_.find_pairs(balls);
    }
    void inspect_cells(Inspector& inspector) const { solver_.inspect_cells(inspector); }

  private:
    void advance_to(const Clock& now, std::vector<Ball>& balls, StepRecord& record);
    void begin(std::vector<Ball>& balls, StepRecord& record);
    void settle(std::vector<Ball>& balls);

    Table& table_;
    const Layout& layout_;
    BroadPhase& broad_;
    SolverSettings settings_;
    ContinuousSolver solver_;
    Sleep sleep_;
    TouchList contacts_;           ///< at the start of the window
    bool contacts_known_ = false;  ///< they are
    bool balls_known_ = false;     ///< to the solver, from the window before
    bool in_window_ = false;
    bool quiet_ = false;
    bool fell_asleep_ = false;
    bool watched_ = false;              ///< who may fall asleep in this window
    double watch_at_ = 0, end_at_ = 0;  ///< s
    bool kept_in_window_ = false;
};

}  // namespace flipside::custom
