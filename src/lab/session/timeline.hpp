#pragma once
/// The steps of a run that lasts a given time: equal ones, and one shorter one at the end if need be.

#include <cstdint>

namespace flipside::lab {

class Timeline {
  public:
    /// From `start` for `seconds` ≥ 0 in steps of `dt` > 0. A rest below 1e-9·dt is no step of its own.
    Timeline(double start, double seconds, double dt);

    [[nodiscard]] std::uint64_t steps() const { return steps_; }
    /// Length of step k = 0 … steps() − 1, s.
    [[nodiscard]] double length(std::uint64_t k) const { return k + 1 == steps_ ? last_ : dt_; }
    [[nodiscard]] double start() const { return start_; }
    [[nodiscard]] double end() const { return start_ + seconds_; }
    [[nodiscard]] double dt() const { return dt_; }

  private:
    double start_, seconds_, dt_;
    std::uint64_t steps_ = 0;
    double last_ = 0;
};

}  // namespace flipside::lab
