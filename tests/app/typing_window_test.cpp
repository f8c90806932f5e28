/// Keys in the real window: those that are typed into a field stay there, those that work the controls work
/// the controls, and the help knows all of them.

#include <set>

#include "app/window/keys.hpp"
#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class TypingWindow : public WindowTest {
  protected:
    /// A click with Ctrl, in one go, so that nothing waits for a frame.
    void ctrl_click(const std::string& control, const std::string& then = "") {
        const Json rect = scroll_to(control)["controls"][control];
        // Its slider is on the left.
        window->xdotool("mousemove " + std::to_string(rect[0].get<int>() + 20) + ' ' +
                        std::to_string(rect[1].get<int>() + rect[3].get<int>() / 2) +
                        " keydown ctrl click 1 keyup ctrl" + then);
    }
};

TEST_F(TypingWindow, CtrlAndAClickOpenAFieldAndItsDigitsStayInIt) {
    open();
    const Json before = window->now();
    ctrl_click("Time", " key 0 key period key 2 key 5 key Return");
    const Json after = window->wait("the speed", [](const Json& s) { return s["speed"] == 0.25; });
    EXPECT_EQ(after["view"], before["view"]);
    EXPECT_EQ(after["paused"], false);
    EXPECT_EQ(after["last_key"], before["last_key"]);
    // Once it is closed keys are the table's again.
    window->key("1");
    wait_for_view("single");
}

TEST_F(TypingWindow, AClickWithoutCtrlMovesTheSlider) {
    open();
    ctrl_click("Time", " key Escape");
    const Json rect = scroll_to("Time")["controls"]["Time"];
    window->xdotool("mousemove " + std::to_string(rect[0].get<int>() + 5) + ' ' +
                    std::to_string(rect[1].get<int>() + 10) + " click 1");
    const Json after = window->wait("a slow table", [](const Json& s) { return s["speed"] < 0.05; });
    window->key("3");
    EXPECT_EQ(wait_for_view("overlay")["paused"], false);
    EXPECT_GT(after["speed"], 0);
}

TEST_F(TypingWindow, EscapeLeavesTheFieldAndNotTheWindow) {
    open();
    const Json before = window->now();
    ctrl_click("Time", " key 9 key Escape");
    window->key("p");
    const Json after = window->wait("the pause", [](const Json& s) { return s["paused"] == true; });
    EXPECT_EQ(after["speed"], before["speed"]);
}

TEST_F(TypingWindow, ControlsAreWorkedByKeysAlone) {
    open();
    window->key("F6");
    window->wait("keys at the controls", [](const Json& s) { return s["by_keys"] == true; });
    const auto focused = [](const std::string& control) {
        return [control](const Json& s) { return s["focus"] == control; };
    };
    const auto walk_to = [&](const std::string& control, const std::string& key) {
        for (int i = 0; i < 30 && window->now()["focus"] != control; ++i) {
            window->key(key);
            // Until the key has been acted on and the report tells of it, however slow the machine is.
            const long frame = window->now()["frame"];
            window->wait("the key", [&](const Json& s) { return s["frame"] > frame + 3; });
        }
        window->wait(control, focused(control));
    };
    walk_to("Pause", "Down");
    window->key("space");
    const Json paused = window->wait("the pause", [](const Json& s) { return s["paused"] == true; });
    EXPECT_TRUE(paused["panes"][0]["balls"].empty()) << "Space also launched";
    walk_to("Inside a step", "Down");
    window->key("space");
    window->wait("the step bar", [](const Json& s) { return s["step_bar"] == true; });
    walk_to("Time", "Down");
    window->xdotool("key Return key 0 key period key 5 key Return");
    window->wait("the speed", [](const Json& s) { return s["speed"] == 0.5; });
    // The list of scenes is right below the tabs.
    walk_to("Scene", "Up");
    window->key("Up");
    window->wait("a tab", [](const Json& s) { return s["focus"] != "Scene"; });
    walk_to("Lesson", "Left");
    walk_to("See", "Right");
    window->key("space");
    window->wait("the other tab", [](const Json& s) { return s["controls"].contains("Boxes"); });
    walk_to("Cells", "Down");
    window->key("space");
    window->wait("cells", [](const Json& s) { return s["show"]["cells"] == true; });
    window->key("Escape");
    window->wait("keys at the table", [](const Json& s) { return s["by_keys"] == false; });
    EXPECT_TRUE(window->program().running());
    window->key("1");
    wait_for_view("single");
}

TEST_F(TypingWindow, EveryKeyIsInTheHelp) {
    open();
    window->key("F1");
    const Json state = window->wait("the help", [](const Json& s) { return s["help"] == true; });
    for (const auto& size : {std::pair{1024, 640}, std::pair{1280, 800}}) {
        window->resize(size.first, size.second);
        window->wait("the size", [&](const Json& s) { return s["layout"]["window"][0] == size.first; });
        const Json shown = settled();
        for (const KeyUse& use : key_uses()) {
            const std::string line = "help: " + std::string(use.names);
            ASSERT_TRUE(shown["controls"].contains(line)) << line;
            const Json& rect = shown["controls"][line];
            EXPECT_GE(rect[0], 0) << line;
            EXPECT_LE(rect[0].get<double>() + rect[2].get<double>(), size.first) << line;
            EXPECT_GE(rect[1], 0) << line;
            EXPECT_LE(rect[1].get<double>() + rect[3].get<double>(), size.second) << line;
        }
    }
}

// What does something has a name for the help, and no two have the same keys.
TEST(Keys, EveryActionHasOneLine) {
    std::set<Action> actions;
    std::set<std::pair<sf::Keyboard::Key, Held>> keys;
    for (const KeyUse& use : key_uses()) {
        EXPECT_TRUE(actions.insert(use.action).second) << use.names;
        EXPECT_FALSE(use.meaning.empty());
        for (const sf::Keyboard::Key key : use.keys) {
            if (key == sf::Keyboard::Unknown) continue;
            EXPECT_TRUE(keys.insert({key, use.with}).second) << use.names << " is there twice";
        }
    }
    for (int action = 1; action <= static_cast<int>(Action::quit); ++action)
        EXPECT_TRUE(actions.contains(static_cast<Action>(action))) << "action " << action << " has no key";
}

}  // namespace
}  // namespace flipside::app
