#include <algorithm>

#include <SFML/Window/Joystick.hpp>

#include "app/window/gamepad.hpp"

namespace flipside::app {

PadState read_gamepad() {
    using Stick = sf::Joystick;
    PadState state;
    unsigned pad = 0;
    while (pad < Stick::Count && !Stick::isConnected(pad)) ++pad;
    if (pad == Stick::Count) return state;
    state.connected = true;
    state.button_count = Stick::getButtonCount(pad);
    for (unsigned i = 0; i < std::min<std::size_t>(state.button_count, state.buttons.size()); ++i)
        state.buttons[i] = Stick::isButtonPressed(pad, i);
    for (unsigned i = 0; i < state.axes.size(); ++i)
        state.axes[i] = Stick::getAxisPosition(pad, static_cast<Stick::Axis>(i));
    state.has_u_and_v = Stick::hasAxis(pad, Stick::U) && Stick::hasAxis(pad, Stick::V);
    return state;
}

}  // namespace flipside::app
