#pragma once
/// A contender's run of the scene in the window: the session and what the window remembers of it.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/window/history.hpp"
#include "app/window/step_numbers.hpp"
#include "app/window/traces.hpp"
#include "lab/comparison/impact_log.hpp"
#include "lab/contenders/contender.hpp"
#include "lab/replay/play.hpp"
#include "lab/session/ball_edit.hpp"
#include "lab/session/recorder.hpp"
#include "lab/session/session.hpp"

namespace flipside::app {

/// Rates over the last whole second of the wall clock. While the table stands still, those per step are of
/// the last step, and those per second stay as they were.
struct Rates {
    double pair_tests = 0, narrow_tests = 0, impacts = 0;  ///< per wall second
    double pair_tests_per_step = 0, narrow_tests_per_step = 0;
    double step_seconds = 0;   ///< CPU time per step that was not traced; 0: none yet
    std::size_t overlaps = 0;  ///< balls at another ball's exact position
};

/// An engine that cannot go on stays where it is, and says why.
struct Halt {
    double time = 0;  ///< s
    std::string reason;
};

class Run {
  public:
    /// The script is taken up at the session's time. The session is on the contender's engine.
    Run(const lab::Contender& contender, lab::Session session, const Script& script);

    /// On by `span` s in steps of its own, in portions, as World::step_within has it: true once that is done.
    /// Does nothing, and is done, once the run has halted.
    [[nodiscard]] bool step_within(double span, const Script& script, double seconds);
    /// On to the first moment at `time` s or after it by the steps of a replay, in whose first session the
    /// run began. False where it has ended, or has halted, before that.
    bool follow(lab::ReplaySteps& replay, double time);
    /// Whatever its world does in a step is written there from now on; null: nowhere.
    /// Those steps do not count in what a step costs.
    void trace(Trace* trace);
    /// A span has begun and not ended.
    [[nodiscard]] bool under_way() const { return session_.under_way() || done_ > 0; }
    /// What the player does, as far as the rules permit it; false if they do not.
    bool press(const Control& control);
    /// Continues as another contender or on a changed scene, from the state as it is.
    void change(std::shared_ptr<const Scene> scene, const lab::Contender& contender);
    /// Takes every ball off the table, and those that wait to be launched.
    void clear();
    /// Whether a hand can do that to its balls (ball_edit.hpp).
    [[nodiscard]] bool permits(const lab::BallEdit& edit) const;
    /// Does it where it can be done.
    void edit(const lab::BallEdit& edit);
    /// Its last half minute, and where in it the run stands.
    [[nodiscard]] const lab::Recorder& recorder() const { return recorder_; }
    /// Shows the last recorded moment at or before `time` as it was, or the first one. What came after it
    /// stays recorded.
    void go_to(double time, const Script& script);
    /// What was recorded after the moment on show is forgotten: the run goes on from here.
    void go_on_from_here();
    /// Whether all that was done to it is what a player's keys do: no hand on the balls, no other engine,
    /// settings or launch than the game's own, no script, and nothing taken back.
    [[nodiscard]] bool played_by_hand() const;
    /// Once per wall second: `running` of it the table ran, s.
    void refresh(double running);

    [[nodiscard]] const lab::Session& session() const { return session_; }
    [[nodiscard]] const Engine& engine() const { return session_.engine(); }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] double dt() const { return dt_; }  ///< its own step, s
    /// How many runs before it on show are on the same engine.
    [[nodiscard]] int twin() const { return twin_; }
    void set_twin(int twin) { twin_ = twin; }
    /// Everything that happened in the last span.
    [[nodiscard]] std::span<const Event> events() const { return events_; }
    [[nodiscard]] const Traces& traces() const { return traces_; }
    /// All that is recorded of them, also those after a moment of the past that is on show.
    [[nodiscard]] const lab::ImpactLog& impacts() const { return impacts_; }
    [[nodiscard]] const Rates& rates() const { return rates_; }
    [[nodiscard]] double energy() const { return energy_; }  ///< J
    /// Energy gained since balls last came or went, J.
    [[nodiscard]] double energy_drift() const { return energy_ - energy_before_; }
    /// Of each step, as long as it is recorded.
    [[nodiscard]] const std::deque<StepNumbers>& numbers() const { return numbers_; }
    /// CPU time per step, smoothed, s.
    [[nodiscard]] double step_cost() const { return step_cost_; }
    /// CPU time per simulated second, smoothed, s: of runs whose steps differ in length.
    [[nodiscard]] double cost_per_second() const { return step_cost_ / dt_; }
    [[nodiscard]] const std::optional<Halt>& halt() const { return halt_; }
    /// The worst of what the engine claims about its balls over time, in radii; empty for engines that claim
    /// nothing.
    [[nodiscard]] const std::deque<Sample>& uncertainty_history() const { return uncertainty_; }
    /// Whether all that it claimed at `time` was within the horizon, so that others can be measured by it.
    /// Engines that claim nothing are.
    [[nodiscard]] bool is_measure_at(double time) const;
    /// When the first of the balls on the table passed beyond the horizon (claim.hpp), s.
    [[nodiscard]] std::optional<double> passed_horizon() const;

  private:
    void observe_step();
    /// The moment on show is another one than the steps led to.
    void record_change();
    /// Sums and rates go on from the session as it is.
    void count_from_here();
    /// Of the step that is done, s; not a number where it was traced.
    [[nodiscard]] double take_cost();
    void measure_energy(bool start_anew);
    void measure_uncertainty();

    std::string name_;
    double dt_;
    int twin_ = 0;
    lab::Session session_;
    std::size_t next_control_;  ///< of the script
    std::uint64_t done_ = 0;    ///< steps of the span that is under way
    std::vector<Event> events_;
    lab::Recorder recorder_;
    std::vector<Control> pressed_;       ///< since the last span
    bool went_back_ = false;             ///< and on from there
    std::optional<Halt> recorded_halt_;  ///< at the end of what is recorded
    Traces traces_;
    lab::ImpactLog impacts_;
    Rates rates_;
    lab::Totals counted_;  ///< at the last refresh
    double energy_ = 0, energy_before_ = 0;
    std::deque<Sample> baselines_;  ///< of energy_before_, since when
    std::size_t balls_ = 0;
    double step_cost_ = 0;
    bool traced_ = false;  ///< from now on
    double spent_ = 0;     ///< CPU time on all steps that are done, s
    struct {
        std::uint64_t steps = 0;
        double seconds = 0;  ///< CPU time
    } timed_;                ///< since the last refresh
    std::deque<StepNumbers> numbers_;
    std::optional<Halt> halt_;
    std::deque<Sample> uncertainty_;
    std::optional<double> passed_horizon_;  ///< as far as is recorded
};

}  // namespace flipside::app
