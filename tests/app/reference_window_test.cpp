/// The reference in the real window: its pane, its ghost, its claims, and what happens where it stops.

#include <fstream>

#include <unistd.h>

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class ReferenceWindow : public WindowTest {
  protected:
    Json show_reference() {
        window->key("e");
        return window->wait("the reference",
                            [](const Json& s) { return s["reference"] == true && s["panes"].size() == 3; });
    }
    /// A scene file beside the window's report, which outlives the window.
    std::string scene_of(const std::string& json) {
        std::ofstream(file) << json;
        return file;
    }
    void TearDown() override {
        WindowTest::TearDown();
        std::filesystem::remove(file);
    }

    std::string file = testing::TempDir() + "flipside-reference-" + std::to_string(getpid()) + ".json";
};

const Json& pane_of(const Json& state, const std::string& engine) {
    for (const Json& pane : state["panes"])
        if (pane["engine"] == engine) return pane;
    throw std::runtime_error("no pane of " + engine);
}

/// How far two engines are apart, in radii; −1 where that is not known yet.
double apart(const Json& state, const std::string& a, const std::string& b) {
    for (const Json& pair : state["divergences"])
        if ((pair["first"] == a && pair["second"] == b) || (pair["first"] == b && pair["second"] == a))
            return pair["radii"].is_null() ? -1 : pair["radii"].get<double>();
    return -1;
}

TEST_F(ReferenceWindow, AKeyShowsAndHidesAThirdPaneOfEqualSize) {
    open();
    const Json state = show_reference();
    EXPECT_EQ(state["panes"][2]["engine"], "reference");
    const Json& panes = state["layout"]["panes"];
    ASSERT_EQ(panes.size(), 3U);
    ASSERT_EQ(state["layout"]["headers"].size(), 3U);
    for (const Json& pane : panes) {
        EXPECT_EQ(pane[2], panes[0][2]);
        EXPECT_EQ(pane[3], panes[0][3]);
    }
    for (const Json& pane : state["panes"]) EXPECT_EQ(pane["time"], state["time"]);
    window->key("e");
    const Json hidden = window->wait("two panes", [](const Json& s) { return s["panes"].size() == 2; });
    EXPECT_EQ(hidden["reference"], false);
}

TEST_F(ReferenceWindow, ClicksShowItAndTakeItUpAgain) {
    open("drop", "split", "box2d");
    click("Reference");
    window->wait("a difference", [](const Json& s) { return apart(s, "box2d", "reference") > 1e-6; });
    const Json before = pause();
    click("Take up again");
    const Json after =
        window->wait("none", [](const Json& s) { return apart(s, "box2d", "reference") == -1; });
    EXPECT_EQ(pane_of(after, "reference")["balls"][0]["position"],
              pane_of(after, "box2d")["balls"][0]["position"]);
    EXPECT_EQ(pane_of(after, "custom")["balls"], pane_of(before, "custom")["balls"]);
    EXPECT_EQ(apart(after, "box2d", "custom"), apart(before, "box2d", "custom"));
    click("Reference");
    window->wait("two panes", [](const Json& s) { return s["panes"].size() == 2; });
}

TEST_F(ReferenceWindow, InTheSingleViewItGoesAroundTheRunningBall) {
    open("pinball", "single");
    launch();
    wait_for_balls();
    const Json before = pause();
    window->key("e");
    const Json after = window->wait("the reference", [](const Json& s) { return s["panes"].size() == 2; });
    EXPECT_EQ(after["panes"][0]["engine"], "custom");
    EXPECT_EQ(after["panes"][1]["engine"], "reference");
    EXPECT_EQ(after["layout"]["panes"].size(), 1U);
    for (const Json& pane : after["panes"])
        EXPECT_LT(distance(before["panes"][0]["balls"][0]["position"], pane["balls"][0]["position"]), 1e-9);
    window->key("e");
    window->wait("custom alone", [](const Json& s) { return s["panes"].size() == 1; });
}

TEST_F(ReferenceWindow, OnOneTableItsBallsAreGreenRingsAroundTheOthers) {
    open("box", "overlay");
    show_reference();
    pause();
    window->key("r");
    window->wait("the start", [](const Json& s) { return s["time"] == 0; });
    window->key("period");
    window->wait("a step", [](const Json& s) { return apart(s, "custom", "reference") >= 0; });
    window->key("F12");
    const Json state = window->wait(
        "the screenshot", [](const Json& s) { return !s["last_screenshot"].get<std::string>().empty(); });
    sf::Image image;
    ASSERT_TRUE(image.loadFromFile(state["last_screenshot"].get<std::string>()));
    ASSERT_EQ(state["layout"]["panes"].size(), 1U);
    EXPECT_LT(apart(state, "custom", "reference"), 1e-9);
    const sf::Color green(0x00, 0x9e, 0x73);
    for (const Json& ball : pane_of(state, "reference")["balls"]) {
        EXPECT_LT(ball["uncertainty"], 1e-9);
        const double radius = ball["pixel_radius"];
        EXPECT_TRUE(ring_has(image, ball["pixel"], radius + 3, green));
        EXPECT_FALSE(ring_has(image, ball["pixel"], radius - 1, green));
    }
}

TEST_F(ReferenceWindow, ABallAmongBumpersPassesItsHorizon) {
    open(scene_of(R"({"format": "flipside-scene/1", "name": "bumpers", "about": "A fast ball among pins.",
            "bounds": {"min": [-1.1, -1.1], "max": [1.1, 1.1]}, "gravity": [0, 0],
            "balls": [{"position": [0.55, 0.12], "velocity": [9, 5], "radius": 0.05, "mass": 1}],
            "parts": [
              {"name": "walls", "shape": {"type": "polyline", "closed": true,
                                          "points": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}},
              {"name": "a", "shape": {"type": "circle", "center": [0, 0], "radius": 0.3}},
              {"name": "b", "shape": {"type": "circle", "center": [0.6, 0.6], "radius": 0.2}},
              {"name": "c", "shape": {"type": "circle", "center": [-0.6, 0.5], "radius": 0.2}},
              {"name": "d", "shape": {"type": "circle", "center": [-0.5, -0.6], "radius": 0.2}},
              {"name": "e", "shape": {"type": "circle", "center": [0.6, -0.5], "radius": 0.2}}]})"));
    const Json shown = show_reference();
    const double claimed = pane_of(shown, "reference")["balls"][0]["uncertainty"];
    EXPECT_LT(claimed, 1e-6);
    EXPECT_TRUE(pane_of(shown, "reference")["horizon"].is_null());
    const Json past = window->wait(
        "the horizon", [](const Json& s) { return !pane_of(s, "reference")["horizon"].is_null(); });
    // Past it the claim is worth nothing, if it is there at all: infinity is null in JSON.
    const Json& ball = pane_of(past, "reference")["balls"][0];
    EXPECT_TRUE(ball["uncertainty"].is_null() || ball["uncertainty"] >= 0.1);
    window->key("t");
    window->wait("certainty again",
                 [](const Json& s) { return pane_of(s, "reference")["horizon"].is_null(); });
}

TEST_F(ReferenceWindow, WhileItsStepsTakeLongTheWindowGoesOn) {
    open(scene_of(R"({"format": "flipside-scene/1", "name": "rain", "about": "800 balls in long steps.",
            "gravity": [0, -9.8], "recommend": {"run": {"dt": 0.1}, "reference": {"precision": "113"}},
            "generate": [{"type": "field", "seed": 1, "balls": 800, "density": 1.6,
                          "ball": {"radius": 0.1, "mass": 1}}]})"));
    show_reference();
    Json begun;
    const Json later = window->wait("frames during a step", [&](const Json& s) {
        if (s["under_way"] == false || begun.is_null() || begun["time"] != s["time"]) begun = s;
        return s["under_way"] == true && s["frame"].get<int>() >= begun["frame"].get<int>() + 3;
    });
    for (const Json& pane : later["panes"]) EXPECT_EQ(pane["time"], later["time"]);
    const Json paused = pause();
    window->key("period");
    window->wait("one step", [&](const Json& s) { return s["time"] > paused["time"]; });
    window->key("e");
    window->wait("two panes", [](const Json& s) { return s["panes"].size() == 2; });
}

TEST_F(ReferenceWindow, WhereItRefusesTheOthersGoOnAndItSaysWhy) {
    open(scene_of(R"({"format": "flipside-scene/1", "name": "pile", "about": "One on the other.",
            "bounds": {"min": [-1, -1], "max": [1, 1]}, "gravity": [0, -9.81],
            "balls": [{"position": [0, 0.1], "radius": 0.1, "mass": 1},
                      {"position": [0, 0.31], "radius": 0.1, "mass": 1},
                      {"position": [0, 0.8], "radius": 0.1, "mass": 1}],
            "materials": {"soft": {"restitution": 0}},
            "parts": [{"name": "floor", "material": "soft",
                       "shape": {"type": "segment", "a": [-1, 0], "b": [1, 0]}}]})"),
         "overlay", "reference");
    const auto halted = [](const Json& s) { return !pane_of(s, "reference")["halted"].is_null(); };
    const Json stopped = window->wait("the refusal", halted);
    const Json why = pane_of(stopped, "reference")["halted"];
    EXPECT_NE(why["reason"].get<std::string>().find("in resting contact"), std::string::npos) << why;
    EXPECT_EQ(why["time"], pane_of(stopped, "reference")["time"]);
    const double time = stopped["time"];
    const Json later = window->wait("the others", [&](const Json& s) { return s["time"] > time + 0.3; });
    EXPECT_EQ(pane_of(later, "reference")["halted"], why);
    window->key("t");
    const Json again = window->wait(
        "it to be taken up", [&](const Json& s) { return pane_of(s, "reference")["time"] >= later["time"]; });
    EXPECT_GT(pane_of(again, "reference")["time"], why["time"]);
}

}  // namespace
}  // namespace flipside::app
