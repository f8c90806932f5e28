/// The first minutes of somebody who has never seen the program: from the offer of a first start to the way
/// out, by keys and clicks alone.

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

namespace fs = std::filesystem;

class StrangerWindow : public WindowTest {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-stranger-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        home = name;
        window = std::make_unique<RealWindow>(std::vector<std::string>{}, home);
    }
    void TearDown() override {
        WindowTest::TearDown();
        fs::remove_all(home);
    }
    /// Presses a key until the window shows that stage of the step.
    Json stage_by(const std::string& key, const std::string& stage) {
        window->key(key);
        return window->wait(
            stage, [&](const Json& s) { return s.contains("inside") && s["inside"]["name"] == stage; });
    }
    void choose(const std::string& control, const std::string& entry) {
        click(control);
        const Json open = window->wait(entry, [&](const Json& s) { return s["controls"].contains(entry); });
        window->click(open["controls"][entry]);
    }

    fs::path home;
};

TEST_F(StrangerWindow, FindsTheWayFromTheOfferToTheExit) {
    ASSERT_TRUE(settled()["controls"].contains("Start lesson 1"));
    click("Start lesson 1");
    Json state = window->wait("the first lesson", [](const Json& s) { return s.contains("lesson"); });
    EXPECT_EQ(state["lesson"]["name"], "01-one-frame");
    EXPECT_EQ(state["paused"], true);

    // What the lesson asks to do: four stages on, and back to where the ball was.
    const auto first_ball = [](const Json& s) { return s["inside"]["balls"][0]["position"]; };
    const Json moved = first_ball(stage_by("period", "move"));
    stage_by("period", "broad phase");
    EXPECT_EQ(first_ball(stage_by("period", "narrow phase")), moved);
    EXPECT_NE(first_ball(stage_by("period", "response")), moved);
    EXPECT_EQ(first_ball(stage_by("comma", "narrow phase")), moved);

    click("Move only");
    state = window->wait("an answer", [](const Json& s) { return s["lesson"]["answered"] == 0; });
    click("Move and response");
    window->wait("the right answer", [](const Json& s) { return s["lesson"]["answered"] == 1; });
    click("Check it");
    state = window->wait("the check", [](const Json& s) { return s["lesson"].contains("holds"); });
    for (const Json& holds : state["lesson"]["holds"]) EXPECT_EQ(holds, true);

    // Another engine under the running balls, and another step.
    window->key("p");
    window->wait("the balls to fly", [](const Json& s) { return s["time"] > 0.2; });
    window->key("Tab");
    state = window->wait("another engine", [](const Json& s) { return s["panes"][0]["engine"] == "box2d"; });
    EXPECT_EQ(state["panes"][0]["balls"].size(), 3U);
    choose("box2d: Step", "Step 1/240 s");
    state = window->wait("the step", [](const Json& s) { return s["panes"][0]["dt"] == 1.0 / 240; });

    // A step of that one from inside, then the past.
    const double paused = pause()["time"];
    window->key("period");
    state = window->wait("its stages", [](const Json& s) { return s.contains("inside"); });
    EXPECT_EQ(state["inside"]["engine"], "box2d");
    EXPECT_GT(state["time"], paused);
    window->key("i");
    window->wait("the bar to close", [](const Json& s) { return s["step_bar"] == false; });
    window->key("comma");
    window->wait("a step back", [&](const Json& s) { return s["in_past"] == true && s["time"] <= paused; });
    window->key("Home");
    window->wait("the beginning", [](const Json& s) { return s["time"] == s["record"][0]; });
    window->key("End");
    window->wait("the end", [](const Json& s) { return s["in_past"] == false; });

    window->key("Escape");
    EXPECT_EQ(window->program().wait(60), 0);
}

}  // namespace
}  // namespace flipside::app
