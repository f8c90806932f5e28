/// Back in time in the real window, by keys and by the mouse.

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class RewindWindow : public WindowTest {
  protected:
    /// Presses a key and waits for the time that it should lead to.
    Json go(const std::string& key, double time) {
        window->key(key);
        return window->wait(key,
                            [&](const Json& s) { return std::abs(s["time"].get<double>() - time) < 1e-9; });
    }
};

TEST_F(RewindWindow, StepByStepBackAndForthAndOnFromThere) {
    open("drop");
    window->wait("some time", [](const Json& s) { return s["time"] > 0.5; });
    const Json now = pause();
    const double end = now["time"];
    EXPECT_EQ(now["record"][0], 0);
    EXPECT_EQ(now["in_past"], false);
    const double step = 1.0 / 60;
    const Json one = go("comma", end - step);
    const Json two = go("comma", end - 2 * step);
    EXPECT_EQ(two["in_past"], true);
    EXPECT_NEAR(two["record"][1].get<double>(), end, 1e-9);
    EXPECT_EQ(go("period", end - step)["panes"], one["panes"]);
    EXPECT_EQ(go("period", end)["panes"], now["panes"]);
    const Json first = go("Home", 0);
    EXPECT_EQ(first["panes"][0]["steps"], 0);
    EXPECT_EQ(go("End", end)["panes"], now["panes"]);
    // The custom engine promises the same future.
    go("comma", end - step);
    window->key("p");
    window->wait("later", [&](const Json& s) { return s["time"] > end + 0.2 && s["in_past"] == false; });
}

TEST_F(RewindWindow, TheMouseDragsAlongTheLineAndAPressForgetsTheRest) {
    open("pinball");
    launch();
    wait_for_balls();
    const Json before = window->wait("some time", [](const Json& s) { return s["record"][1] > 2; });
    const Json line = before["layout"]["scrubber"];
    const auto at = [&](double share) {
        return std::to_string(static_cast<int>(line[0].get<double>() + share * line[2].get<double>())) + ' ' +
               std::to_string(static_cast<int>(line[1].get<double>() + line[3].get<double>() / 2));
    };
    window->xdotool("mousemove " + at(0.9) + " mousedown 1 mousemove " + at(0.5) + " sleep 0.2 mouseup 1");
    const Json back = window->wait("the past", [](const Json& s) {
        return s["in_past"] == true && s["time"] < 0.6 * s["record"][1].get<double>();
    });
    EXPECT_EQ(back["paused"], true);
    EXPECT_NEAR(back["time"].get<double>() / back["record"][1].get<double>(), 0.5, 0.05);
    for (const Json& pane : back["panes"]) EXPECT_NEAR(pane["time"], back["time"], 1e-9);
    window->key("n");
    const Json forked = window->wait("a fork", [](const Json& s) { return s["in_past"] == false; });
    EXPECT_NEAR(forked["record"][1].get<double>(), forked["time"].get<double>(), 1e-9);
    EXPECT_LT(forked["time"], 0.6 * back["record"][1].get<double>());
}

}  // namespace
}  // namespace flipside::app
