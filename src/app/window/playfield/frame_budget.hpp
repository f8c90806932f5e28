#pragma once
/// Whether there is time to draw the artwork. Where frames come too seldom, and it is not the engines that
/// take the time, it is left out for a while; each time that this was needed again, for twice as long.

#include <algorithm>

namespace flipside::app {

class FrameBudget {
  public:
    static constexpr double least_rate = 45;      ///< frames per second, of 60
    static constexpr double most_physics = 0.35;  ///< of the time, or the engines are to blame
    static constexpr int patience = 3;            ///< bad seconds in a row
    static constexpr double first_pause = 20, most_pause = 1280;  ///< s

    [[nodiscard]] bool affords_artwork() const { return left_out_for_ <= 0; }

    /// Once about every second, with what was measured in the `seconds` since the last call.
    void observe(double seconds, double frames_per_second, double physics) {
        if (!affords_artwork()) {
            left_out_for_ -= seconds;
            return;
        }
        const bool bad = frames_per_second < least_rate && physics < most_physics;
        bad_ = bad ? bad_ + 1 : 0;
        if (bad_ < patience) return;
        bad_ = 0;
        left_out_for_ = pause_;
        pause_ = std::min(2 * pause_, most_pause);
    }

  private:
    int bad_ = 0;
    double left_out_for_ = 0;
    double pause_ = first_pause;
};

}  // namespace flipside::app
