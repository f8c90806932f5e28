#pragma once
/// The rows of a sweep: one per variant, contender, step size and window, as work units write them.

#include <filesystem>
#include <string>
#include <vector>

#include "lab/sweep/measure.hpp"
#include "lab/sweep/plan.hpp"

namespace flipside::lab::sweep {

/// What a divergence is blamed on (lab/blame/blame.hpp), as files have it.
struct Charge {
    Fault fault = Fault::unknown;
    std::string kind;  ///< one of met_kinds
    std::string met;   ///< name of the part, or "ball:N"; "" in flight
    BallNumber ball = 0;
    double time = 0;    ///< s
    double amount = 0;  ///< as in Blame
};
[[nodiscard]] Charge charge_of(const Blame& blame, const Scene& scene);

struct Run {
    std::string variant, contender;
    double dt = 0;           ///< s
    std::size_t window = 0;  ///< of the variant, from 0
    double seconds = 0;      ///< the window's length
    Outcome outcome;
    std::optional<Charge> blame;  ///< of what diverged, and of nothing else
    /// Least and median CPU time of several repetitions, s; not a number where the window was not timed.
    double cpu_min = 0, cpu_median = 0;
};

/// CSV; columns named cpu_* hold measurements of time, everything else is the same on every machine:
/// variant,contender,dt,window,seconds,failure,error,typical,impacts,missed,spurious,
/// fault,kind,met,ball,at,amount,cpu_min,cpu_median
[[nodiscard]] std::string to_csv(const std::vector<Run>& runs);
/// Throws InputError for what are no runs of this unit: each of a contender of the plan at one of its step
/// sizes, on a window of the unit, once, in this order, with numbers that such a run may have. `file` is for
/// messages.
[[nodiscard]] std::vector<Run> parse_runs(const std::string& csv, const std::filesystem::path& file,
                                          const Plan& plan, const Unit& unit);

}  // namespace flipside::lab::sweep
