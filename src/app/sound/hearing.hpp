#pragma once
/// All that is heard of a stage: each run in its pane, from left to right.

#include <string>
#include <vector>

#include "app/sound/ear.hpp"
#include "app/sound/mixer.hpp"
#include "app/window/stage.hpp"

namespace flipside::app::sound {

class Hearing {
  public:
    /// Strikes what sounded in the last step of all runs, which went from `from` s. `now` is the simulated
    /// time at which the mixer goes on; a simulated second lasts 1/speed s.
    void hear(const Stage& stage, double from, double now, double speed, Mixer& mixer);
    /// From here on they roll as they do now; where nothing moves, not at all.
    void roll(const Stage& stage, bool moving, double speed, Mixer& mixer) const;

  private:
    struct Listener {
        std::string run;
        Ear ear;
    };
    std::vector<Listener> listeners_;  ///< one for each run on show
};

}  // namespace flipside::app::sound
