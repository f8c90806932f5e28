#pragma once
/// A progress bar on stderr where that is a terminal, with the time left, and nothing otherwise.

#include <chrono>

namespace flipside::app {

class Progress {
  public:
    /// Of work that is `whole` long, in any unit that grows evenly with time: simulated seconds, shares,
    /// runs.
    explicit Progress(double whole);
    /// Wipes the bar.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// At most ten times a second something is written. The time left is reckoned from the first call on, so
    /// that what was done before (by a run that is resumed) does not count as quick work.
    void at(double done);

  private:
    using Clock = std::chrono::steady_clock;

    double whole_;
    bool shown_;         ///< stderr is a terminal
    double first_ = -1;  ///< share done at the first call; negative before it
    Clock::time_point began_{}, next_{};
};

}  // namespace flipside::app
