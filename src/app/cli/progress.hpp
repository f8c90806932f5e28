#pragma once
/// A progress bar on stderr where that is a terminal, and nothing otherwise.

#include <chrono>

namespace flipside::app {

class Progress {
  public:
    /// Of a run that lasts `seconds` of simulated time.
    explicit Progress(double seconds);
    /// Wipes the bar.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// At most ten times a second something is written.
    void at(double seconds_done);

  private:
    double seconds_;
    bool shown_;  ///< stderr is a terminal
    std::chrono::steady_clock::time_point next_{};
};

}  // namespace flipside::app
