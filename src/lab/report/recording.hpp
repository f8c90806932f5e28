#pragma once
/// A quantity of one run, recorded over time into a file of its own.

#include <memory>
#include <string>
#include <vector>

#include "lab/report/contender.hpp"
#include "lab/report/measurement.hpp"
#include "lab/session/session.hpp"

namespace flipside::lab::report {

struct RunPlan {
    std::shared_ptr<const Scene> scene;
    Contender contender;
    double seconds;
    double dt = 1.0 / 60;
    double limit = 20;  ///< CPU seconds after which the run is given up
};

/// Runs the plan and calls `after` with the session at the start and after every step. Returns "" or why the
/// run ended early: a refusal, a ball that is no number any more, the limit.
[[nodiscard]] std::string run_plan(const RunPlan& plan, const std::function<void(const Session&)>& after,
                                   const Watch& watch);

/// Returns a CSV: time,value,failure. About 120 samples, and where the run failed one more, infinite, with
/// the reason.
[[nodiscard]] std::string record(const RunPlan& plan, const std::function<double(const Session&)>& quantity,
                                 const Watch& watch);

/// The samples of such a file as points.
[[nodiscard]] std::vector<Point> recorded(const Data& data, const std::string& file);

}  // namespace flipside::lab::report
