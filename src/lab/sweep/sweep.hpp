#pragma once
/// Work-precision data: every contender of contenders.hpp at every step size on the same windows, with its
/// error and its cost. All of it lies in one folder:
///
///     plan.json                 what is swept (plan.hpp); a folder holds one plan
///     windows/VARIANT-BLOCK.json   the states windows start from, and their exact outcome (windows.hpp)
///     runs/VARIANT-BLOCK.csv       a row per run (runs.hpp)
///     sweep.csv                 the figures of merit (summary.hpp), once all runs are there
///     blame.csv                 divergences by what they begin with (blame_counts.hpp), then too
///
/// A work unit is a block of a variant's windows with all contenders, interleaved. Each unit has its own
/// trajectories and its own files: units may be made in any order, by any number of processes at once, and a
/// sweep that was stopped goes on with those that are missing. All but sweep.csv and blame.csv are data files
/// (data_file.hpp): one that is damaged, or of another sweep, is made again.

#include <functional>
#include <map>

#include "lab/files/data_file.hpp"
#include "lab/sweep/plan.hpp"

namespace flipside::lab::sweep {

/// Every n-th unit: shards 1/n … n/n together are all of them.
struct Shard {
    std::size_t index = 1, count = 1;
};

/// Makes what is missing of the shard's units. `watch` is called often, with the share done, and may throw to
/// stop; `notice` is told which files are made again, and why. Throws InputError when the folder holds
/// another plan.
void make_runs(const Plan& plan, Shard shard, const std::filesystem::path& folder,
               const std::function<void(double)>& watch, const Notice& notice);

/// The windows of a variant.
struct Windows {
    std::size_t windows = 0, trajectories = 0;
    std::map<std::string, std::size_t> skipped;  ///< states that made no window, by reason
};
/// What a folder of this plan holds.
struct Inventory {
    bool is_complete = true;                 ///< the files of all units are there
    std::map<std::string, Windows> windows;  ///< by variant
};
/// Throws Failure for a file that is damaged.
[[nodiscard]] Inventory take_inventory(const Plan& plan, const std::filesystem::path& folder);

}  // namespace flipside::lab::sweep
