#pragma once
/// What the sticks and buttons of a gamepad ask of the table. Knows no device.

#include <array>
#include <span>
#include <vector>

#include "app/window/keys.hpp"

namespace flipside::app {

/// As SFML numbers the axes and reads them: −100…100, y downwards; 0 for an axis that is not there.
struct PadState {
    enum Axis { x, y, z, r, u, v, cross_x, cross_y };

    bool connected = false;
    std::array<bool, 16> buttons{};
    unsigned button_count = 0;
    std::array<float, 8> axes{};
    bool has_u_and_v = false;  ///< then these are the right stick, and z and r are the triggers
};

class Gamepad {
  public:
    struct Change {
        Action action;
        bool down;
        friend bool operator==(const Change&, const Change&) = default;
    };

    /// What was pressed and let go since the last call. Sticks and triggers have to come back farther than to
    /// where they were pressed, so that none flutters; a nudge is over when stick and cross are at rest. Of a
    /// gamepad that is gone all is let go but the plunger, which falls back without a launch. Valid until the
    /// next call.
    std::span<const Change> observe(const PadState& now);
    [[nodiscard]] bool held(Action action) const;

  private:
    void set(Action action, bool down);
    void nudge(const PadState& now);

    std::vector<Action> held_;
    std::vector<Change> changes_;
    bool left_trigger_ = false, right_trigger_ = false, pulled_ = false;
};

/// Of the first gamepad that is plugged in (gamepad_device.cpp).
[[nodiscard]] PadState read_gamepad();

}  // namespace flipside::app
