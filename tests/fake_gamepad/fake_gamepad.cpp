/// SFML's functions for joysticks, answered from the file that FLIPSIDE_FAKE_GAMEPAD names: eight axes in
/// SFML's order, then the numbers of the buttons that are pressed. Without the file nothing is plugged in.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <vector>

#include <SFML/Window/Joystick.hpp>

namespace {

struct Pad {
    float axes[8]{};
    std::vector<unsigned> buttons;
};

std::optional<Pad> pad() {
    const char* file = std::getenv("FLIPSIDE_FAKE_GAMEPAD");
    std::ifstream in(file == nullptr ? "" : file);
    Pad read;
    for (float& axis : read.axes)
        if (!(in >> axis)) return std::nullopt;
    for (unsigned button = 0; in >> button;) read.buttons.push_back(button);
    return read;
}

}  // namespace

namespace sf {

bool Joystick::isConnected(unsigned joystick) {
    return joystick == 0 && pad();
}
unsigned Joystick::getButtonCount(unsigned /*joystick*/) {
    return 11;
}
bool Joystick::hasAxis(unsigned /*joystick*/, Axis /*axis*/) {
    return true;
}
bool Joystick::isButtonPressed(unsigned /*joystick*/, unsigned button) {
    const auto read = pad();
    return read && std::find(read->buttons.begin(), read->buttons.end(), button) != read->buttons.end();
}
float Joystick::getAxisPosition(unsigned /*joystick*/, Axis axis) {
    const auto read = pad();
    return read ? read->axes[axis] : 0;
}

}  // namespace sf
