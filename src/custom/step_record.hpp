#pragma once
/// What the solvers report of a step.

#include "custom/touch_list.hpp"
#include "world/events.hpp"
#include "world/statistics.hpp"
#include "world/trace.hpp"

namespace flipside::custom {

struct StepRecord {
    std::vector<Event> events;
    std::vector<Sensed> crossed;  ///< sensors met
    Statistics statistics;
    Trace* trace = nullptr;  ///< of the step, where somebody wants it
    /// Wall time of each stage, s.
    double broad_seconds = 0, flight_seconds = 0, contact_seconds = 0, report_seconds = 0;
};

}  // namespace flipside::custom
