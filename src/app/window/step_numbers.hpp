#pragma once
/// What one step of a run cost and found: a line of the numbers that the window plots, shows and exports.

#include <deque>

#include "world/statistics.hpp"
#include "world/world.hpp"

namespace flipside::app {

struct StepNumbers {
    double time = 0;    ///< s, at the end of the step
    double energy = 0;  ///< J
    double cost = 0;    ///< CPU time of the step, s
    Statistics statistics;
    std::size_t balls = 0;
    double deepest = 0;  ///< deepest overlap at the end of the step, m
    double dt = 0;       ///< of the run, s
};

/// The last one at or before `time`; null where there is none.
[[nodiscard]] const StepNumbers* numbers_at(const std::deque<StepNumbers>& numbers, double time);

}  // namespace flipside::app
