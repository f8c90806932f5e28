#pragma once
/// One work unit of a sweep: every entrant at every step size on one block of windows.

#include "lab/sweep/sweep.hpp"

namespace flipside::lab::sweep {

/// First every run once, for its error. Then the timed windows again, `repetitions` times: one round is all
/// entrants in turn, so that what else the machine does meets them alike, and nothing but World::step is in
/// the time. `watch` gets the share done.
[[nodiscard]] std::vector<Run> measure_unit(const Plan& plan, const Unit& unit, const Block& block,
                                            const std::shared_ptr<const Scene>& scene,
                                            const std::function<void(double)>& watch);

}  // namespace flipside::lab::sweep
