/// What becomes of a game when it is over.

#include "app/window/app.hpp"

namespace flipside::app {

/// Once per frame.
void App::look_after_game() {
    if (!is_over(stage_)) {
        state_.end.reset();
        return;
    }
    if (state_.end) return;
    state_.end = end_of(stage_);
    // A game that was gone back in and is over again was entered already.
    if (entered_game_ != stage_.games() && helped_game_ != stage_.games() && !stage_.is_lesson())
        enter_scores(stage_, high_scores_, *state_.end);
    entered_game_ = stage_.games();
    state_.end->high = high_scores_.of(kept_name(stage_.scene_name()));
    if (!high_scores_.trouble().empty()) controls_.notice = high_scores_.trouble();
}

/// Space, once no game goes on. That it is let go launches nothing.
bool App::play_again() {
    if (!is_over(stage_)) return false;
    stage_.restart();
    state_.charge = 0;
    return true;
}

}  // namespace flipside::app
