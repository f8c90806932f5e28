#pragma once
/// One engine's run of the scene in the window: the session and what the window remembers of it.

#include <deque>
#include <string>

#include "app/window/traces.hpp"
#include "lab/session.hpp"

namespace flipside::app {

/// Rates over the last whole second of the wall clock.
struct Rates {
    double pair_tests = 0, narrow_tests = 0, impacts = 0;  ///< per wall second
    double pair_tests_per_step = 0, narrow_tests_per_step = 0;
    double step_seconds = 0;   ///< CPU time per step
    std::size_t overlaps = 0;  ///< balls at another ball's exact position
};

struct Sample {
    double time = 0, value = 0;
};

class Run {
  public:
    /// The script is taken up at the session's time.
    Run(lab::Session session, const Script& script);

    /// A run whose engine has refused to go on stays where it is until change().
    void step(double dt, const Script& script);
    /// Continues on another engine, with other settings or on a changed scene, from the state as it is.
    void change(std::shared_ptr<const Scene> scene, const Engine& engine, Settings settings);
    /// Takes every ball off the table, and those that wait to be launched.
    void clear();
    /// Once per wall second: `seconds` since the last call.
    void refresh(double seconds);

    [[nodiscard]] lab::Session& session() { return session_; }
    [[nodiscard]] const lab::Session& session() const { return session_; }
    [[nodiscard]] const Traces& traces() const { return traces_; }
    [[nodiscard]] const Rates& rates() const { return rates_; }
    /// Why the engine refused to go on; empty while it does.
    [[nodiscard]] const std::string& refusal() const { return refusal_; }
    [[nodiscard]] double energy() const { return energy_; }  ///< J
    /// Energy gained since balls last came or went, J.
    [[nodiscard]] double energy_drift() const { return energy_ - energy_before_; }
    /// Energy over time, the last `history_seconds` of it.
    [[nodiscard]] const std::deque<Sample>& energy_history() const { return history_; }
    /// CPU time per step, smoothed, s.
    [[nodiscard]] double step_cost() const { return step_cost_; }

    static constexpr double history_seconds = 12;

  private:
    void measure_energy(bool start_anew);

    lab::Session session_;
    std::size_t next_control_;  ///< of the script
    Traces traces_;
    Rates rates_;
    lab::Totals counted_;  ///< at the last refresh
    double energy_ = 0, energy_before_ = 0;
    std::size_t balls_ = 0;
    double step_cost_ = 0;
    std::string refusal_;
    std::deque<Sample> history_;
};

/// Appends a sample and drops those older than `seconds`.
void remember(std::deque<Sample>& history, Sample sample, double seconds);

}  // namespace flipside::app
