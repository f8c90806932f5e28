#pragma once
/// Work-precision data: every entrant of entrants.hpp at every step size on the same windows, with its
/// error and its cost. All of it lies in one folder:
///
///     plan.json                 what is swept; a folder holds one plan
///     windows/VARIANT-BLOCK.json   the states windows start from, and their exact outcome (windows.hpp)
///     runs/VARIANT-BLOCK.csv       a row per run (runs.hpp)
///     sweep.csv                 the figures of merit (summary.hpp), once all runs are there
///
/// A work unit is a block of a variant's windows with all entrants, interleaved. Each unit has its own
/// trajectories and its own files, which are there as a whole or not at all: units may be made in any order,
/// by any number of processes at once, and a run that was stopped goes on with those that are missing.

#include <functional>

#include "lab/sweep/entrants.hpp"
#include "lab/sweep/runs.hpp"

namespace flipside::lab::sweep {

struct Plan {
    std::vector<Variant> variants{};
    std::vector<const Entrant*> entrants = all_entrants();
    std::uint64_t seed = 1;
    std::uint32_t blocks = 20;    ///< per variant
    std::size_t block_size = 25;  ///< windows
    std::size_t timed = 3;        ///< windows of each block that are timed, and
    std::size_t repetitions = 5;  ///< how often
    int finest = finest_steps;    ///< steps per second at most
    double most_work = 3'000;     ///< balls times steps in a window, above which windows are left out

    [[nodiscard]] std::size_t windows() const { return blocks * block_size; }
};
/// A plan of fewer windows and no step below 1/960 s, for a first look.
[[nodiscard]] Plan quick_plan(std::vector<Variant> variants, std::uint64_t seed);
[[nodiscard]] std::string to_json(const Plan& plan);

/// The step sizes at which an entrant is swept, s, the largest first.
[[nodiscard]] std::vector<double> steps_of(const Entrant& entrant, const Plan& plan);
/// Only every n-th window of a variant is run where many balls take many steps: n is a power of two, such
/// that balls and steps of n windows make no more than n times the plan's most_work.
[[nodiscard]] std::size_t thinning(const Plan& plan, std::size_t balls, double seconds, double dt);

struct Unit {
    const Variant* variant;
    std::uint32_t block;
};
[[nodiscard]] std::vector<Unit> units_of(const Plan& plan);
/// Every n-th unit: shards 1/n … n/n together are all of them.
struct Shard {
    std::size_t index = 1, count = 1;
};

/// Makes what is missing of the shard's units. `watch` is called often, with the share done, and may throw to
/// stop. Throws InputError when the folder holds another plan.
void make_runs(const Plan& plan, Shard shard, const std::filesystem::path& folder,
               const std::function<void(double)>& watch);
[[nodiscard]] bool is_complete(const Plan& plan, const std::filesystem::path& folder);

}  // namespace flipside::lab::sweep
