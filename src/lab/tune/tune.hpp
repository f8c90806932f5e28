#pragma once
/// `flipside sweep --tune`: how cheap can an engine be made on a scene, at an error that is asked for, and
/// how does that compare with our own engine as it comes? Settings are searched on some windows (tuner.hpp)
/// and judged on others.

#include <iosfwd>
#include <optional>

#include "lab/statistics/median.hpp"
#include "lab/sweep/contenders.hpp"
#include "lab/tune/tuner.hpp"

namespace flipside::lab::tune {

struct Request {
    const Engine* engine = nullptr;
    std::vector<double> targets{1e-1, 1e-2, 1e-3};  ///< radii, > 0
    std::uint64_t seed = 1;
    std::size_t windows = 25;          ///< to search on, and as many to judge on
    int finest = sweep::finest_steps;  ///< steps per second at most
    double most_seconds = 600;         ///< of CPU time, about, to search for one target
};

/// A contender, judged.
struct Judged {
    Contender contender;
    std::string text{};  ///< for --contender
    Score score{};       ///< on the windows of the judgement, all of them timed
};

struct Tuning {
    std::string variant;
    double target;   ///< radii
    Judged tuned;    ///< what the search found, or the engine as it comes where that is judged better
    Judged untuned;  ///< the engine as it comes, at the longest step that meets the target
    Judged ours;     ///< the continuous solver, likewise, whatever the scene recommends
    std::size_t tried;
    /// Cost of the tuned one over that of the others, window by window. Nothing where one of them failed in
    /// all.
    std::optional<Median> over_untuned{}, over_ours{};
};

/// One per target, the largest first. Throws InputError for a variant without windows. `watch` is called
/// often and may throw to stop.
[[nodiscard]] std::vector<Tuning> tune(const Request& request, const sweep::Variant& variant,
                                       const std::function<void(double)>& watch);

/// CSV, three rows each: the contender (`role`), its error in radii, its CPU seconds per simulated second,
/// and how many times that the tuned one costs, with a confidence interval of 95 %; nan where it is not
/// known.
void write_csv(std::ostream& out, std::span<const Tuning> all);

}  // namespace flipside::lab::tune
