#include "app/window/gamepad.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::app {

namespace {

/// Two kinds are about, by the numbers that Linux gives their buttons: one has its triggers among them, the
/// other has not.
constexpr unsigned with_triggers = 12;
constexpr unsigned south = 0, left_shoulder = 4, right_shoulder = 5;
constexpr unsigned left_trigger = 6, right_trigger = 7;  ///< where they are buttons
constexpr unsigned start_after_triggers = 9, start_without = 7;

constexpr float trigger_down = 20, trigger_up = -20;  ///< from −100 at rest
constexpr float stick_out = 60, stick_back = 35;

/// Beyond `out` it begins, below `back` it ends.
void follow(bool& on, float value, float out, float back) {
    on = on ? value > back : value > out;
}

}  // namespace

bool Gamepad::held(Action action) const {
    return std::ranges::find(held_, action) != held_.end();
}

void Gamepad::set(Action action, bool down) {
    if (down == held(action)) return;
    if (down)
        held_.push_back(action);
    else
        std::erase(held_, action);
    changes_.push_back({action, down});
}

std::span<const Gamepad::Change> Gamepad::observe(const PadState& now) {
    changes_.clear();
    if (!now.connected) {
        std::erase(held_, Action::launch);
        const std::vector<Action> rest = held_;
        for (const Action action : rest) set(action, false);
        left_trigger_ = right_trigger_ = pulled_ = false;
        return changes_;
    }
    const bool triggers = now.button_count >= with_triggers;
    follow(left_trigger_, now.has_u_and_v ? now.axes[PadState::z] : -100, trigger_down, trigger_up);
    follow(right_trigger_, now.has_u_and_v ? now.axes[PadState::r] : -100, trigger_down, trigger_up);
    follow(pulled_, now.axes[now.has_u_and_v ? PadState::v : PadState::r], stick_out, stick_back);
    set(Action::flip_left,
        now.buttons[left_shoulder] || left_trigger_ || (triggers && now.buttons[left_trigger]));
    set(Action::flip_right,
        now.buttons[right_shoulder] || right_trigger_ || (triggers && now.buttons[right_trigger]));
    set(Action::launch, now.buttons[south] || pulled_);
    set(Action::pause, now.buttons[triggers ? start_after_triggers : start_without]);
    nudge(now);
    return changes_;
}

void Gamepad::nudge(const PadState& now) {
    const float across = std::abs(now.axes[PadState::x]) >= std::abs(now.axes[PadState::cross_x])
                             ? now.axes[PadState::x]
                             : now.axes[PadState::cross_x];
    // Whether the cross's up is positive differs between systems, and only forward makes sense.
    const float cross = -std::abs(now.axes[PadState::cross_y]), stick = now.axes[PadState::y];
    const float along = std::abs(stick) >= -cross ? stick : cross;
    const float way = std::max(std::abs(across), std::abs(along));
    constexpr Action nudges[] = {Action::nudge_left, Action::nudge_forward, Action::nudge_right};
    if (std::ranges::any_of(nudges, [&](Action action) { return held(action); })) {
        if (way < stick_back)
            for (const Action action : nudges) set(action, false);
        return;
    }
    if (way < stick_out) return;
    if (std::abs(across) >= std::abs(along))
        set(across < 0 ? Action::nudge_left : Action::nudge_right, true);
    else if (along < 0)  // a player pushes a table, but does not pull it
        set(Action::nudge_forward, true);
}

}  // namespace flipside::app
