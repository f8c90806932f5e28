#pragma once
/// Turns frame times, which vary, into a whole number of equal steps of physics, so that the speed of the
/// table never depends on the frame rate (Fiedler 2004, "Fix Your Timestep!").

#include <algorithm>
#include <cmath>

namespace flipside::app {

class Accumulator {
  public:
    /// `dt` > 0: the step, s. `most` ≥ dt: simulated seconds that one frame may catch up at most; what is
    /// beyond is dropped, so a slow machine runs slower instead of falling ever further behind.
    Accumulator(double dt, double most) : dt_(dt), most_(std::max(dt, most)) {}

    /// The steps that are due after `seconds` more of simulated time.
    [[nodiscard]] int advance(double seconds) {
        waiting_ = std::min(waiting_ + std::max(0.0, seconds), most_);
        // A hair of tolerance, or sixty frames of 1/60 s would make fifty-nine steps.
        const int steps = static_cast<int>(std::floor(waiting_ / dt_ + 1e-9));
        waiting_ = std::max(0.0, waiting_ - steps * dt_);
        return steps;
    }

    [[nodiscard]] double dt() const { return dt_; }
    [[nodiscard]] double waiting() const { return waiting_; }  ///< s, not stepped yet, < dt

  private:
    double dt_;
    double most_;
    double waiting_ = 0;
};

}  // namespace flipside::app
