#pragma once
/// The cheapest settings and step of an engine whose error is no larger than asked for, found by search on a
/// scene: coordinate descent over every setting (search_space.hpp) and the step, from two places: the engine
/// as it comes at the shortest step, and what a search for a larger error found, at first the engine as it
/// comes at the longest. What it finds is a local optimum. Costs are measured, so runs differ where
/// candidates cost nearly the same.

#include <set>
#include <span>

#include "lab/process/cpu_clock.hpp"
#include "lab/session/run_settings.hpp"
#include "lab/tune/trial.hpp"

namespace flipside::lab::tune {

struct Found {
    Contender contender;
    Score score{};          ///< on the windows of the search
    std::size_t tried = 0;  ///< contenders measured for this target
};

class Tuner {
  public:
    /// Steps are 1/30 s and its halves down to 1/finest. A search for one target begins no further trial
    /// after `most_seconds` of CPU time, half of them from each place. Both references must outlive this.
    Tuner(const Engine& engine, const Trials& trials, int finest, double most_seconds);

    /// The cheapest found with an error of at most `target` radii; where there is none the most accurate.
    [[nodiscard]] Found cheapest(double target);

  private:
    [[nodiscard]] Found descend(const Contender& start, double target);
    bool improve_step(Found& best, double target);
    bool improve_setting(Found& best, const SettingSpec& spec, double target);
    bool take(Found& best, const Contender& other, double target);

    const Engine& engine_;
    const Trials& trials_;
    std::vector<double> steps_;    ///< s
    Contender plain_;              ///< as it comes, at the longest step
    Contender start_;              ///< of the next search
    double most_cost_ = 0;         ///< CPU seconds per simulated second
    double most_seconds_;          ///< of CPU time, from one place
    CpuStopwatch watch_;           ///< since the search from this place began
    std::set<std::string> tried_;  ///< for this target
};
inline constexpr std::size_t most_trials = 400;  ///< for one target, from one place

/// The engine's defaults, with the scene's and then these changes, at the longest of these steps that meets
/// the target, or the shortest.
[[nodiscard]] Found untuned(const Engine& engine, const Trials& trials, int finest, double target,
                            std::span<const SettingChange> changes = {});

}  // namespace flipside::lab::tune
