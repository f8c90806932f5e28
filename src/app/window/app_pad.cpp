/// What a gamepad does in the window.

#include "app/window/app.hpp"

namespace flipside::app {

/// Once per frame: so a gamepad may come and go while the program runs. It plays in the window in front only.
void App::read_pad() {
    const PadState now = window_.hasFocus() ? read_gamepad() : PadState{};
    if (!now.connected && pad_.held(Action::launch)) state_.charge = 0;
    for (const auto& [action, down] : pad_.observe(now)) perform(action, down);
}

}  // namespace flipside::app
