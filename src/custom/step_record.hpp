#pragma once
/// Results of a step that the solvers record.

#include <chrono>

#include "custom/touch_list.hpp"
#include "world/events.hpp"
#include "world/statistics.hpp"
#include "world/trace.hpp"

namespace flipside::custom {

struct StepRecord {
    std::vector<Event> events;
    std::vector<Sensed> crossed;  ///< sensors with which balls overlapped
    Statistics statistics;
    Trace* trace = nullptr;  ///< trace of the step, or null
};

/// Measures the stages of a step: lap() adds the wall time since the last lap to a stage.
class Stopwatch {
  public:
    void lap(StageTime& stage) {
        const auto now = std::chrono::steady_clock::now();
        stage.seconds += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace flipside::custom
