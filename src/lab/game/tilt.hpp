#pragma once
/// Nudges, counted: too many in too short a time tilt the table until the ball is lost.

#include <vector>

#include "world/scene.hpp"

namespace flipside::lab {

class Tilt {
  public:
    enum class Answer { none, warning, tilted };

    /// A warning comes with the last nudge that is still allowed.
    Answer nudge(const Rules& rules, double time) {
        std::erase_if(nudges_, [&](double earlier) { return earlier <= time - rules.tilt_seconds; });
        nudges_.push_back(time);
        const auto count = static_cast<int>(nudges_.size());
        if (tilted_) return Answer::none;
        if (count >= rules.tilt_nudges) {
            tilted_ = true;
            return Answer::tilted;
        }
        return count == rules.tilt_nudges - 1 ? Answer::warning : Answer::none;
    }
    void reset() { *this = {}; }
    [[nodiscard]] bool tilted() const { return tilted_; }

  private:
    std::vector<double> nudges_;  ///< times of the last ones, s
    bool tilted_ = false;
};

}  // namespace flipside::lab
