#pragma once
/// One scene, one script, several contenders: results and costs of each, and where they diverge.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lab/blame/blame_run.hpp"
#include "lab/comparison/parting.hpp"
#include "lab/contenders/contender.hpp"
#include "lab/session/run.hpp"
#include "lab/session/run_figures.hpp"

namespace flipside::lab {

struct CompareInput {
    std::shared_ptr<const Scene> scene;
    std::vector<Contender> contenders;  ///< at least one; the others are compared with the first
    double seconds = 10;
    Script script;
};

struct EngineRun {
    Contender contender;
    RunFigures figures;
    std::vector<Event> impacts;
    struct Ended {
        double time = 0;  ///< s, where the step begins that could not be made
        std::string why;
    };
    std::optional<Ended> ended{};     ///< before its time: the figures are those until then
    std::optional<RunBlame> blame{};  ///< against the reference; nothing for the reference itself
};

/// The first contender against another one.
struct Pair {
    struct Parted {
        double time;
        Spread spread;
        std::optional<Event> after;  ///< the last impact of that ball until then, in the first contender
    };
    std::size_t second = 1;  ///< index of the other
    ImpactMatch match;
    std::vector<double> radii;     ///< after each step that both made: Spread::radii
    std::optional<Parted> parted;  ///< when a ball was first more than a radius apart, or gone from one only
    Spread at_end;
};

struct Comparison {
    CompareInput input;
    std::vector<EngineRun> runs;
    std::vector<Pair> pairs;
    double dt = 0;              ///< s: the longest step, after which all are held against each other
    std::vector<double> times;  ///< s, after each of these
};

/// Runs all contenders side by side, each for the longest step of all in turn, so that all meet the same
/// machine. One that cannot go on ends alone. Then each but the reference is held against that, for blame.
/// `watch` is called after every step with the share of all this that is done. Throws InputError where their
/// steps do not meet (common_step).
[[nodiscard]] Comparison compare(CompareInput input, const std::function<void(double)>& watch = {});

[[nodiscard]] std::string to_json(const Comparison& comparison);

}  // namespace flipside::lab
