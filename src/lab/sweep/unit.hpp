#pragma once
/// One work unit of a sweep: every contender at every step size on one block of windows.

#include "lab/sweep/runs.hpp"

namespace flipside::lab::sweep {

/// First every run once, for its error. Then the timed windows again, `repetitions` times: one round is all
/// contenders in turn, so that what else the machine does meets them alike, and nothing but World::step is in
/// the time. `watch` gets the share done.
[[nodiscard]] std::vector<Run> measure_unit(const Plan& plan, const Unit& unit, const Block& block,
                                            const std::shared_ptr<const Scene>& scene,
                                            const std::function<void(double)>& watch);

/// Throws InputError where these are not all runs that measure_unit() makes of the block. They must be as
/// parse_runs() leaves them; `file` is for messages.
void require_all_runs(const std::vector<Run>& runs, const Plan& plan, const Unit& unit, const Block& block,
                      const std::filesystem::path& file);

}  // namespace flipside::lab::sweep
