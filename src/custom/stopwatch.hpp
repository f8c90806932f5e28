#pragma once

#include <chrono>

namespace flipside::custom {

/// Adds the time since the last call to a stage.
class Stopwatch {
  public:
    void lap(double& seconds) {
        const auto now = std::chrono::steady_clock::now();
        seconds += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace flipside::custom
