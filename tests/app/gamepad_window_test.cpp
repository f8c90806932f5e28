/// A gamepad in the real window: a library in place of SFML's joysticks reads it from a file.

#include <fstream>

#include "app/window_fixture.hpp"
#include "places.hpp"

namespace flipside::app {
namespace {

class GamepadWindow : public WindowTest {
  protected:
    void SetUp() override {
#ifdef FLIPSIDE_SANITIZED
        GTEST_SKIP() << "the sanitizer's own library has to come first";
#endif
        file = std::filesystem::temp_directory_path() / ("flipside-gamepad-" + std::to_string(getpid()));
        setenv("FLIPSIDE_FAKE_GAMEPAD", file.c_str(), 1);
        setenv("LD_PRELOAD", test::fake_gamepad_library, 1);
        open();
        unsetenv("LD_PRELOAD");
    }
    void TearDown() override {
        WindowTest::TearDown();
        std::filesystem::remove(file);
        unsetenv("FLIPSIDE_FAKE_GAMEPAD");
    }
    /// Sticks at rest, but for how far the right one is pulled down.
    void hold(const std::string& buttons, int pulled = 0, int across = 0) const {
        const auto next = std::filesystem::path(file).concat(".next");
        std::ofstream(next) << across << " 0 -100 -100 0 " << pulled << " 0 0 " << buttons << '\n';
        rename(next, file);
    }
    static bool all_flippers_up(const Json& state, const char* side, bool up) {
        for (const Json& pane : state["panes"])
            for (const Json& flipper : pane["flippers"])
                if (flipper["side"] == side && (flipper["angle"] != 0) != up) return false;
        return true;
    }

    std::filesystem::path file;
};

TEST_F(GamepadWindow, PluggedInWhileTheProgramRunsItPlays) {
    hold("4");
    window->wait("the left flippers", [](const Json& s) { return all_flippers_up(s, "left", true); });
    hold("5");
    window->wait("the right flippers alone", [](const Json& s) {
        return all_flippers_up(s, "left", false) && all_flippers_up(s, "right", true);
    });
    hold("", 100);
    window->wait("the charge", [](const Json& s) { return s["charge"] > 0.6; });
    hold("");
    const Json launched = wait_for_balls();
    EXPECT_EQ(launched["charge"], 0);
    const auto sideways = [](const Json& s) {
        return s["panes"][0]["balls"][0]["velocity"][0].get<double>();
    };
    const double before = sideways(launched);
    hold("", 0, -100);
    window->wait("a nudge to the left", [&](const Json& s) { return sideways(s) < before - 0.2; });
    hold("7");
    window->wait("the pause", [](const Json& s) { return s["paused"] == true; });
}

TEST_F(GamepadWindow, UnpluggedItLetsGo) {
    hold("4 0");
    window->wait("the left flippers and a charge",
                 [](const Json& s) { return all_flippers_up(s, "left", true) && s["charge"] > 0.2; });
    std::filesystem::remove(file);
    const Json state =
        window->wait("the fall", [](const Json& s) { return all_flippers_up(s, "left", false); });
    EXPECT_EQ(state["charge"], 0);
    for (const Json& pane : state["panes"]) EXPECT_EQ(pane["launched"], 0);
}

}  // namespace
}  // namespace flipside::app
