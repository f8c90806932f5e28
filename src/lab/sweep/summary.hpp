#pragma once
/// A sweep's figures of merit: the rows of any number of folders brought together, one line per variant,
/// contender and step size. Figures and report are drawn from this.

#include <map>
#include <span>

#include "lab/sweep/runs.hpp"

namespace flipside::lab::sweep {

/// What divergences are counted by.
struct BlameKey {
    Fault fault;
    std::string kind, met;  ///< as in Charge

    friend auto operator<=>(const BlameKey&, const BlameKey&) = default;
};
using BlameCounts = std::map<BlameKey, std::size_t>;

struct Figures {
    std::string variant, contender;
    std::string engine, settings;                 ///< of the contender
    double dt = 0;                                ///< s
    std::size_t windows = 0;                      ///< runs
    std::size_t failed = 0;                       ///< of these; their errors count as infinite
    std::map<std::string, std::size_t> failures;  ///< those by name
    /// Of the windows' errors (radii, worst ball): median, 95th percentile, maximum. Nearest rank.
    double median = 0, p95 = 0, max = 0;
    double median_low = 0, median_high = 0;  ///< 95 % confidence interval of the median (median.hpp)
    /// The same of the windows' typical errors (radii, median of the balls that were hit): with one ball it
    /// is the same; with hundreds the worst ball tells of one grazing hit, this of the engine.
    double typical_median = 0, typical_p95 = 0;
    std::size_t exact = 0;                              ///< windows with an error of exact_radii at most
    std::size_t impacts = 0, missed = 0, spurious = 0;  ///< sums over all windows
    BlameCounts blame;      ///< of the windows that are not exact, what each is blamed on
    std::size_t timed = 0;  ///< windows that were timed
    /// CPU seconds per simulated second: sums over the timed windows of the least and of the median time.
    double cpu_min = 0, cpu_median = 0;
    std::map<std::size_t, double> costs;  ///< the least time of each timed window, per simulated second
};

/// All runs of these folders, sorted by variant, contender, step size (largest first) and window; a run
/// that several folders hold counts once. Throws InputError for a folder without runs, for folders of
/// different plans, and for a file that is damaged or does not belong there.
[[nodiscard]] std::vector<Run> gather(std::span<const std::filesystem::path> folders);
/// In the order of `runs`, which must be sorted as gather() does.
[[nodiscard]] std::vector<Figures> summarize(std::span<const Run> runs);

/// The CSV of the same columns, failures as "2 lost ball; 1 refused", without `costs` and what
/// blame.csv holds (blame_counts.hpp).
void write_summary(const std::filesystem::path& file, std::span<const Figures> all);

}  // namespace flipside::lab::sweep
