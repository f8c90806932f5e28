#pragma once
/// CPU time of the calling thread: the cost of a step, independent of other programs. A reading costs a
/// good part of a microsecond, as much as a whole step of a small scene, so a stopwatch takes its own
/// cost off what it tells.

#include <algorithm>
#include <ctime>

namespace flipside::lab {

[[nodiscard]] inline double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Least CPU time between two readings in a row, measured at first use, s.
[[nodiscard]] inline double cost_of_reading() {
    static const double least = [] {
        double shortest = 1;
        for (int i = 0; i < 1000; ++i) {
            const double began = cpu_seconds();
            shortest = std::min(shortest, cpu_seconds() - began);
        }
        return shortest;
    }();
    return least;
}

/// CPU time since it was made, without that of the readings, s.
class CpuStopwatch {
  public:
    [[nodiscard]] double seconds() const { return std::max(0.0, cpu_seconds() - began_ - cost_); }

  private:
    double cost_ = cost_of_reading();
    double began_ = cpu_seconds();
};

}  // namespace flipside::lab
