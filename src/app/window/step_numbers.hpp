#pragma once
/// What one step of a run cost and found: a line of the numbers that the window plots, shows and exports.

#include <cmath>
#include <deque>

#include "world/statistics.hpp"
#include "world/world.hpp"

namespace flipside::app {

struct StepNumbers {
    double time = 0;    ///< s, at the end of the step
    double energy = 0;  ///< J
    double cost = 0;    ///< CPU time of the step, s; not a number where it was traced
    Statistics statistics;
    std::size_t balls = 0;
    double deepest = 0;  ///< deepest overlap at the end of the step, m
    double dt = 0;       ///< of the run, s
    Vec2 gravity;        ///< m/s²

    /// To trace a step takes longer than the step, so what it and its stages cost says nothing.
    [[nodiscard]] bool timed() const { return !std::isnan(cost); }
};

/// The last one at or before `time`; null where there is none.
[[nodiscard]] const StepNumbers* numbers_at(const std::deque<StepNumbers>& numbers, double time);

}  // namespace flipside::app
