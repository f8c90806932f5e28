#include "app/sound/live.hpp"

namespace flipside::app::sound {

void Live::begin_frame(const Stage& stage, bool muted, double speed) {
    now_ = stage.time();
    speed_ = speed;
    if (muted == muted_) return;
    muted_ = muted;
    player_.change([&](Mixer& mixer) { mixer.mute(muted); });
}

void Live::step(const Stage& stage, double from) {
    if (!muted_) player_.change([&](Mixer& mixer) { hearing_.hear(stage, from, now_, speed_, mixer); });
}

void Live::end_frame(const Stage& stage, bool moving) {
    player_.change([&](Mixer& mixer) { hearing_.roll(stage, moving, speed_, mixer); });
}

}  // namespace flipside::app::sound
