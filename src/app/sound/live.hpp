#pragma once
/// The sound of the window: what is heard of its stage is played as it happens.

#include "app/sound/hearing.hpp"
#include "app/sound/player.hpp"

namespace flipside::app::sound {

class Live {
  public:
    [[nodiscard]] bool has_device() const { return player_.has_device(); }
    /// Once per frame, before any step: what follows is heard as far after this as it comes to pass in
    /// simulated time, of which a second lasts 1/speed s.
    void begin_frame(const Stage& stage, bool muted, double speed);
    /// After a step of the stage, which went from `from` s. A moment of the past that is shown again is none.
    void step(const Stage& stage, double from);
    /// Once per frame, after all steps; where time stands still nothing rolls.
    void end_frame(const Stage& stage, bool moving);

  private:
    Player player_;
    Hearing hearing_;
    bool muted_ = false;
    double now_ = 0;  ///< s, simulated
    double speed_ = 1;
};

}  // namespace flipside::app::sound
