#include "app/window/gamepad.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

using Change = Gamepad::Change;
using Changes = std::vector<Change>;

/// As Linux shows the one without and the one with triggers among its buttons.
PadState pad_at_rest(unsigned buttons = 11) {
    PadState pad;
    pad.connected = true;
    pad.button_count = buttons;
    pad.has_u_and_v = true;
    pad.axes[PadState::z] = pad.axes[PadState::r] = -100;
    return pad;
}

class GamepadTest : public testing::Test {
  protected:
    Changes observe() {
        const auto changes = pad.observe(state);
        return {changes.begin(), changes.end()};
    }
    Changes axis(PadState::Axis axis, float value) {
        state.axes[axis] = value;
        return observe();
    }
    Changes button(unsigned number, bool down) {
        state.buttons[number] = down;
        return observe();
    }
    Gamepad pad;
    PadState state = pad_at_rest();
};

TEST_F(GamepadTest, AtRestItAsksForNothing) {
    EXPECT_EQ(observe(), Changes{});
    state.axes = {};  // as SFML reads triggers that were never touched
    EXPECT_EQ(observe(), Changes{});
}

TEST_F(GamepadTest, ShouldersAreFlippersWhileHeld) {
    EXPECT_EQ(button(4, true), (Changes{{Action::flip_left, true}}));
    EXPECT_EQ(button(5, true), (Changes{{Action::flip_right, true}}));
    EXPECT_TRUE(pad.held(Action::flip_left));
    EXPECT_EQ(observe(), Changes{});
    EXPECT_EQ(button(4, false), (Changes{{Action::flip_left, false}}));
    EXPECT_FALSE(pad.held(Action::flip_left));
    EXPECT_TRUE(pad.held(Action::flip_right));
}

TEST_F(GamepadTest, TriggersAreFlippersAndDoNotFlutter) {
    EXPECT_EQ(axis(PadState::r, 0), Changes{});
    EXPECT_EQ(axis(PadState::r, 30), (Changes{{Action::flip_right, true}}));
    EXPECT_EQ(axis(PadState::r, 10), Changes{}) << "it has to come back farther";
    EXPECT_EQ(axis(PadState::r, 30), Changes{});
    EXPECT_EQ(axis(PadState::r, -30), (Changes{{Action::flip_right, false}}));
    EXPECT_EQ(axis(PadState::z, 100), (Changes{{Action::flip_left, true}}));
    // A shoulder keeps up what the trigger lets go.
    EXPECT_EQ(button(4, true), Changes{});
    EXPECT_EQ(axis(PadState::z, -100), Changes{});
    EXPECT_EQ(button(4, false), (Changes{{Action::flip_left, false}}));
}

TEST_F(GamepadTest, ThePlungerIsButtonAOrTheRightStickPulledDown) {
    EXPECT_EQ(button(0, true), (Changes{{Action::launch, true}}));
    EXPECT_EQ(button(0, false), (Changes{{Action::launch, false}}));
    EXPECT_EQ(axis(PadState::v, 50), Changes{}) << "within the dead zone";
    EXPECT_EQ(axis(PadState::v, 90), (Changes{{Action::launch, true}}));
    EXPECT_EQ(axis(PadState::v, 50), Changes{});
    EXPECT_EQ(axis(PadState::v, 10), (Changes{{Action::launch, false}}));
    EXPECT_EQ(axis(PadState::v, -100), Changes{}) << "nobody pushes a plunger";
}

TEST_F(GamepadTest, AStickNudgesOnceUntilItIsBackAtRest) {
    EXPECT_EQ(axis(PadState::x, -50), Changes{});
    EXPECT_EQ(axis(PadState::x, -80), (Changes{{Action::nudge_left, true}}));
    EXPECT_EQ(axis(PadState::x, -50), Changes{});
    EXPECT_EQ(axis(PadState::x, -80), Changes{});
    EXPECT_EQ(axis(PadState::x, 90), Changes{}) << "from one side to the other is no second nudge";
    EXPECT_EQ(axis(PadState::x, 5), (Changes{{Action::nudge_left, false}}));
    EXPECT_EQ(axis(PadState::x, 90), (Changes{{Action::nudge_right, true}}));
}

TEST_F(GamepadTest, TheFartherAxisSaysWhereTheNudgeGoes) {
    state.axes[PadState::x] = 70;
    EXPECT_EQ(axis(PadState::y, -95), (Changes{{Action::nudge_forward, true}}));
    state.axes[PadState::x] = 0;
    EXPECT_EQ(axis(PadState::y, 0), (Changes{{Action::nudge_forward, false}}));
    EXPECT_EQ(axis(PadState::y, 100), Changes{}) << "nobody pulls a table";
    EXPECT_EQ(axis(PadState::y, 0), Changes{});
    EXPECT_EQ(axis(PadState::cross_x, 100), (Changes{{Action::nudge_right, true}}));
    EXPECT_EQ(axis(PadState::cross_x, 0), (Changes{{Action::nudge_right, false}}));
    for (const float up : {-100.0F, 100.0F}) {
        EXPECT_EQ(axis(PadState::cross_y, up), (Changes{{Action::nudge_forward, true}}));
        EXPECT_EQ(axis(PadState::cross_y, 0), (Changes{{Action::nudge_forward, false}}));
    }
}

TEST_F(GamepadTest, StartPausesOnBothKinds) {
    EXPECT_EQ(button(7, true), (Changes{{Action::pause, true}}));
    EXPECT_EQ(button(7, false), (Changes{{Action::pause, false}}));
    state = pad_at_rest(13);
    EXPECT_EQ(button(7, true), (Changes{{Action::flip_right, true}})) << "there it is a trigger";
    EXPECT_EQ(button(7, false), (Changes{{Action::flip_right, false}}));
    EXPECT_EQ(button(9, true), (Changes{{Action::pause, true}}));
}

TEST_F(GamepadTest, WithoutUAndVTheRightStickIsZAndR) {
    state = pad_at_rest();
    state.has_u_and_v = false;
    state.axes = {};
    EXPECT_EQ(axis(PadState::z, 100), Changes{}) << "no trigger";
    EXPECT_EQ(axis(PadState::r, 100), (Changes{{Action::launch, true}}));
}

TEST_F(GamepadTest, UnpluggedItLetsGoOfAllAndDoesNotLaunch) {
    button(4, true);
    button(0, true);
    axis(PadState::x, 100);
    state.connected = false;
    EXPECT_EQ(observe(), (Changes{{Action::flip_left, false}, {Action::nudge_right, false}}));
    EXPECT_FALSE(pad.held(Action::launch));
    EXPECT_EQ(observe(), Changes{});
    state.connected = true;  // plugged in again with all of it still held
    EXPECT_EQ(observe().size(), 3U);
}

}  // namespace
}  // namespace flipside::app
