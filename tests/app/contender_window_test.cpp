/// Contenders in the real window: panes of one engine with different settings and steps, chosen by hand.

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class ContenderWindow : public WindowTest {
  protected:
    void open_with(const std::vector<std::string>& contenders, const std::string& scene = "toy") {
        std::vector<std::string> arguments{scene, "--width", "1500", "--height", "900"};
        for (const std::string& contender : contenders)
            arguments.insert(arguments.end(), {"--contender", contender});
        window = std::make_unique<RealWindow>(arguments);
    }
    void choose(const std::string& box, const std::string& choice) {
        click(box);
        window->wait("the choices", [&](const Json& s) { return s["controls"].contains(choice); });
        click_now(choice);
    }
    void click_now(const std::string& control) { window->click(window->now()["controls"][control]); }
};

TEST_F(ContenderWindow, FourPanesEachWithItsOwnSettingsAndStep) {
    open_with({"once=custom,solver=simple,motion_iterations=1",
               "often=custom,solver=simple,motion_iterations=16", "fine=box2d,dt=1/240", "truth=reference"});
    const Json state =
        window->wait("some time", [](const Json& s) { return s["panes"].size() == 4 && s["time"] > 0.2; });
    const char* const names[] = {"once", "often", "fine", "truth"};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(state["panes"][i]["name"], names[i]);
        EXPECT_NEAR(state["panes"][i]["time"].get<double>(), state["time"].get<double>(), 1e-9);
        EXPECT_EQ(state["layout"]["panes"][i][2], state["layout"]["panes"][0][2]);
        EXPECT_EQ(state["layout"]["panes"][i][3], state["layout"]["panes"][0][3]);
    }
    EXPECT_EQ(state["panes"][2]["steps"], 4 * state["panes"][0]["steps"].get<int>());
    EXPECT_EQ(state["engines"][0]["settings"]["motion_iterations"], "1");
    EXPECT_EQ(state["engines"][1]["settings"]["motion_iterations"], "16");
    EXPECT_EQ(state["divergences"].size(), 6U);
}

TEST_F(ContenderWindow, EnginesAndStepsAreChosenByClicksWhileTheBallGoesOn) {
    open("drop", "split", "custom", {"--width", "1500", "--height", "900"});
    click("Add a pane");
    Json state = window->wait("three", [](const Json& s) { return s["panes"].size() == 3; });
    EXPECT_EQ(state["panes"][2]["name"], "box2d-2");
    choose("box2d-2: Step", "Step 1/240 s");
    state = window->wait("its step", [](const Json& s) { return s["panes"][2]["dt"] == 1.0 / 240; });
    EXPECT_EQ(state["panes"][1]["dt"], 1.0 / 60);
    choose("box2d-2: Engine", "Engine reference");
    state = window->wait("the engine", [](const Json& s) { return s["panes"][2]["engine"] == "reference"; });
    EXPECT_EQ(state["panes"][2]["dt"], 1.0 / 240);
    EXPECT_EQ(state["reference"], true);
    const Json paused = pause();
    const double time = paused["time"];
    window->key("period");
    state = window->wait("a step", [&](const Json& s) { return s["time"] > time; });
    EXPECT_EQ(state["panes"][2]["steps"].get<int>(), paused["panes"][2]["steps"].get<int>() + 4);
    click("reference: Remove");
    state = window->wait("two", [](const Json& s) { return s["panes"].size() == 2; });
    EXPECT_EQ(state["reference"], false);
}

TEST_F(ContenderWindow, AStepIsChosenByAClickInItsHeader) {
    open("drop", "split");
    const Json before = settled();
    choose("box2d: Step in the header", "Step 1/120 s");
    Json state = window->wait("its step", [](const Json& s) { return s["panes"][1]["dt"] == 1.0 / 120; });
    EXPECT_EQ(state["panes"][0]["dt"], 1.0 / 60);
    EXPECT_EQ(state["center"], before["center"]);
    // A click on the header beside it chooses nothing.
    const Json header = state["layout"]["headers"][0];
    window->click({header[0], header[1], 4, 4});
    EXPECT_FALSE(settled()["controls"].contains("Step 1/120 s"));
    choose("custom: Step in the header", "Step 1/15 s");
    window->wait("the other's", [](const Json& s) { return s["panes"][0]["dt"] == 1.0 / 15; });
}

TEST_F(ContenderWindow, TheOneThatAllWaitForIsNamedAndTakenAwayByAKey) {
    // One that takes some milliseconds for a step of 1/60 s.
    open_with({"quick=custom", "slow=box2d,substeps=1000"}, "rain");
    const Json slow = window->wait("a word of it", [](const Json& s) { return s["slow"] != ""; });
    EXPECT_TRUE(slow["slow"].get<std::string>().starts_with("Slow: slow takes ")) << slow["slow"];
    window->key("x");
    const Json state = window->wait("one pane", [](const Json& s) { return s["panes"].size() == 1; });
    EXPECT_EQ(state["panes"][0]["name"], "quick");
    window->wait("its own pace", [](const Json& s) { return s["slow"] == ""; });
    window->key("x");
    window->key("p");
    EXPECT_EQ(window->wait("the pause", [](const Json& s) { return s["paused"] == true; })["panes"].size(),
              1U);
}

}  // namespace
}  // namespace flipside::app
