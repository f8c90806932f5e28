#pragma once
/// The rows of a sweep: one per variant, entrant, step size and window, as work units write them.

#include <filesystem>
#include <string>
#include <vector>

#include "lab/sweep/measure.hpp"

namespace flipside::lab::sweep {

struct Run {
    std::string variant, entrant;
    double dt = 0;           ///< s
    std::size_t window = 0;  ///< of the variant, from 0
    double seconds = 0;      ///< the window's length
    Outcome outcome;
    /// Least and median CPU time of several repetitions, s; not a number where the window was not timed.
    double cpu_min = 0, cpu_median = 0;
};

/// CSV; columns named cpu_* hold measurements of time, everything else is the same on every machine:
/// variant,entrant,dt,window,seconds,failure,error,typical,impacts,missed,spurious,cpu_min,cpu_median
void write_runs(const std::filesystem::path& file, const std::vector<Run>& runs);
/// Throws InputError for what is no such file.
[[nodiscard]] std::vector<Run> read_runs(const std::filesystem::path& file);

}  // namespace flipside::lab::sweep
