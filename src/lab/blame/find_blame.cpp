#include "lab/blame/find_blame.hpp"

#include <algorithm>
#include <functional>

#include "lab/blame/continuation.hpp"
#include "lab/blame/wrong_step.hpp"
#include "world/refusal.hpp"

namespace flipside::lab {

namespace {

/// Of the states, the one after which not even the exact engine ends within the tolerance. It must do so from
/// the first, and not from the last.
std::size_t point_of_no_return(std::size_t steps, const std::function<bool(std::size_t)>& is_lost) {
    std::size_t saved = 0, lost = steps;
    while (lost - saved > 1) {
        const std::size_t middle = saved + (lost - saved) / 2;
        (is_lost(middle) ? lost : saved) = middle;
    }
    return lost;
}

Blame nothing_met(Fault fault, const Divergence& divergence, double time) {
    Blame blame;
    blame.fault = fault;
    blame.ball = divergence.ends.front().ball;
    blame.time = time;
    return blame;
}

Blame in_step(const Divergence& divergence, std::size_t step, double tolerance, World& exact) {
    try {
        return WrongStep(divergence, step, tolerance, exact).blame();
    } catch (const Refusal&) {  // past the end of the run, or from a part of the contender's state
        return nothing_met(Fault::unknown, divergence, divergence.history.states[step].clock.time);
    }
}

}  // namespace

Blame find_blame(const Divergence& divergence, World& exact) {
    const History& history = divergence.history;
    const std::size_t steps = history.steps();
    const double tolerance = std::min(0.5 * divergence.error, most_tolerance);
    const auto is_lost = [&](std::size_t k) {
        return worst_if_exact_from(history.states[k], history, divergence.ends, exact).radii > tolerance;
    };
    if (steps == 0) return nothing_met(Fault::stopped, divergence, history.end);
    if (is_lost(0)) return nothing_met(Fault::unknown, divergence, history.states[0].clock.time);
    if (!is_lost(steps)) return nothing_met(Fault::stopped, divergence, history.states.back().clock.time);
    return in_step(divergence, point_of_no_return(steps, is_lost), tolerance, exact);
}

}  // namespace flipside::lab
