/// The real window: what keys and clicks do, seen through what it reports and what it draws.

#include <cmath>
#include <string>

#include <SFML/Graphics/Image.hpp>
#include <gtest/gtest.h>

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class Window : public WindowTest {};

double angle(const Json& pane, const std::string& side) {
    for (const Json& flipper : pane["flippers"])
        if (flipper["side"] == side) return std::abs(flipper["angle"].get<double>());
    return -1;
}

TEST_F(Window, OpensOnTheTableWithBothEnginesInEqualPanes) {
    open();
    const Json state = window->now();
    EXPECT_EQ(state["scene"], "pinball");
    ASSERT_EQ(state["panes"].size(), 2U);
    EXPECT_EQ(state["panes"][0]["engine"], "custom");
    EXPECT_EQ(state["panes"][1]["engine"], "box2d");
    const Json panes = state["layout"]["panes"];
    EXPECT_EQ(panes[0][2], panes[1][2]);
    EXPECT_EQ(panes[0][3], panes[1][3]);
    EXPECT_EQ(state["panes"][0]["time"], state["panes"][1]["time"]);
}

TEST_F(Window, SpaceChargesAndLaunchesInBothPanes) {
    open();
    launch();
    const Json state = window->wait("balls on their way up", [](const Json& s) {
        for (const Json& pane : s["panes"])
            if (pane["balls"].empty() || pane["balls"].back()["velocity"][1] < 0.2) return false;
        return true;
    });
    for (const Json& pane : state["panes"]) EXPECT_EQ(pane["launched"], 1);
    EXPECT_EQ(state["charge"], 0);
}

TEST_F(Window, ALaunchIsChargedWhileTheTableStandsStill) {
    open();
    pause();
    launch();
    const Json charged = window->wait("the launch", [](const Json& s) { return s["charge"] == 0; });
    EXPECT_EQ(charged["paused"], true);
    window->key("p");
    window->wait("balls on their way up", [](const Json& s) {
        for (const Json& pane : s["panes"])
            if (pane["balls"].empty() || pane["balls"].back()["velocity"][1] < 1) return false;
        return true;
    });
}

TEST_F(Window, FlippersAreUpWhileTheirKeysAreHeld) {
    open();
    // Shift keys by their codes (50, 62): by name, xdotool would hold another shift with the right one.
    const std::pair<const char*, const char*> keys[] = {
        {"50", "left"}, {"62", "right"}, {"Left", "left"}, {"Right", "right"}};
    for (const auto& entry : keys) {
        const std::string key = entry.first, side = entry.second;
        const std::string other = side == "left" ? "right" : "left";
        window->xdotool("keydown " + key);
        const Json up = window->wait("the flipper of " + key, [&](const Json& s) {
            return angle(s["panes"][0], side) > 0.3 && angle(s["panes"][1], side) > 0.3;
        });
        EXPECT_EQ(angle(up["panes"][0], other), 0);
        EXPECT_EQ(angle(up["panes"][1], other), 0);
        window->xdotool("keyup " + key);
        window->wait("it to fall again", [&](const Json& s) {
            return angle(s["panes"][0], side) == 0 && angle(s["panes"][1], side) == 0;
        });
    }
}

TEST_F(Window, TabSwitchesTheEngineUnderTheRunningBall) {
    open("pinball", "single");
    launch();
    wait_for_balls();
    const Json before = pause();
    ASSERT_EQ(before["panes"].size(), 1U);
    ASSERT_EQ(before["panes"][0]["engine"], "custom");
    window->key("Tab");
    const Json after =
        window->wait("the other engine", [](const Json& s) { return s["panes"][0]["engine"] == "box2d"; });
    const Json &ball = before["panes"][0]["balls"][0], &same = after["panes"][0]["balls"][0];
    EXPECT_EQ(ball["number"], same["number"]);
    EXPECT_LT(distance(ball["position"], same["position"]), 1e-6 * 0.0135);
    EXPECT_LT(distance(ball["velocity"], same["velocity"]), 1e-6);
    EXPECT_EQ(before["panes"][0]["time"], after["panes"][0]["time"]);
    window->key("p");
    const double time = after["time"];
    window->wait("the run to go on", [&](const Json& s) { return s["time"] > time + 0.1; });
    window->key("Tab");
    window->wait("the first engine", [](const Json& s) { return s["panes"][0]["engine"] == "custom"; });
}

TEST_F(Window, PauseStopsTimeAndPeriodTakesOneStep) {
    open();
    const Json paused = pause();
    const long frame = paused["frame"];
    const Json later = window->wait("more frames", [&](const Json& s) { return s["frame"] > frame + 10; });
    EXPECT_EQ(later["time"], paused["time"]);
    for (int i = 1; i <= 3; ++i) {
        window->key("period");
        const long steps = paused["panes"][0]["steps"];
        const Json stepped =
            window->wait("a step", [&](const Json& s) { return s["panes"][0]["steps"] >= steps + i; });
        EXPECT_EQ(stepped["panes"][0]["steps"], steps + i);
        EXPECT_EQ(stepped["panes"][1]["steps"], stepped["panes"][0]["steps"]);
        EXPECT_EQ(stepped["paused"], true);
    }
    window->key("p");
    window->wait("time to go on",
                 [&](const Json& s) { return s["time"] > paused["time"].get<double>() + 0.2; });
}

TEST_F(Window, RestartBeginsTheSceneAgain) {
    open();
    launch();
    wait_for_balls();
    const Json before = window->wait("half a second", [](const Json& s) { return s["time"] > 0.5; });
    pause();
    window->key("r");
    const Json after = window->wait("time 0", [](const Json& s) { return s["time"] == 0; });
    for (const Json& pane : after["panes"]) {
        EXPECT_EQ(pane["launched"], 0);
        EXPECT_EQ(pane["score"], 0);
        EXPECT_GT(pane["balls_left"], before["panes"][0]["balls_left"]);
    }
}

TEST_F(Window, KeysChooseTheView) {
    open();
    window->key("1");
    EXPECT_EQ(wait_for_view("single")["panes"].size(), 1U);
    window->key("3");
    const Json overlay = wait_for_view("overlay");
    EXPECT_EQ(overlay["panes"].size(), 2U);
    EXPECT_EQ(overlay["layout"]["panes"].size(), 1U);
    window->key("2");
    EXPECT_EQ(wait_for_view("split")["layout"]["panes"].size(), 2U);
    window->key("v");
    wait_for_view("overlay");
    window->key("v");
    wait_for_view("single");
}

TEST_F(Window, ASecondEngineTakesOverWhatIsOnTheTable) {
    open("pinball", "single");
    launch();
    wait_for_balls();
    pause();
    window->key("2");
    const Json split = wait_for_view("split");
    ASSERT_EQ(split["panes"].size(), 2U);
    EXPECT_LT(distance(split["panes"][0]["balls"][0]["position"], split["panes"][1]["balls"][0]["position"]),
              1e-8);
    EXPECT_EQ(split["panes"][0]["time"], split["panes"][1]["time"]);
    EXPECT_EQ(split["panes"][0]["balls_left"], split["panes"][1]["balls_left"]);
}

TEST_F(Window, LayoutFollowsTheWindow) {
    open();
    for (const auto& size : {std::pair{1024, 640}, std::pair{1900, 1000}}) {
        const int width = size.first, height = size.second;
        window->resize(width, height);
        const Json state = window->wait("the new size", [&](const Json& s) {
            return s["layout"]["window"][0] == width && s["layout"]["window"][1] == height;
        });
        const Json &panes = state["layout"]["panes"], &panel = state["layout"]["panel"];
        EXPECT_EQ(panes[0][2], panes[1][2]);
        EXPECT_EQ(panel[0].get<double>() + panel[2].get<double>(), width);
        EXPECT_LE(panes[1][0].get<double>() + panes[1][2].get<double>(), panel[0]);
        EXPECT_GT(panes[0][3], 0.5 * height);
    }
}

TEST_F(Window, HelpOpensAndEscapeClosesItAndThenTheWindow) {
    open();
    window->key("F1");
    window->wait("the help", [](const Json& s) { return s["help"] == true; });
    window->key("Escape");
    window->wait("no help", [](const Json& s) { return s["help"] == false; });
    EXPECT_TRUE(window->program().running());
    window->key("Escape");
    EXPECT_EQ(window->program().wait(60), 0);
}

TEST_F(Window, EscapeAsksBeforeItEndsAGame) {
    open();
    launch();
    wait_for_balls();
    window->key("Escape");
    window->wait("the question",
                 [](const Json& s) { return s["notice"] == "A game is under way. Esc once more ends it."; });
    EXPECT_TRUE(window->program().running());
    window->key("Escape");
    EXPECT_EQ(window->program().wait(60), 0);
}

// Each counts, and where the mouse was.
TEST_F(Window, ClicksWithinOneFrameAllCount) {
    open("drop", "single");
    click("See");
    const Json controls = scroll_to("Boxes")["controls"];
    std::string clicks;
    for (const char* name : {"Boxes", "Pairs", "Cells"}) {
        const Json& rect = controls[name];
        clicks += " mousemove " + std::to_string(rect[0].get<int>() + 8) + ' ' +
                  std::to_string(rect[1].get<int>() + 8) + " click 1";
    }
    window->program().hold();
    window->xdotool(clicks);
    window->program().go_on();
    window->wait("all three", [](const Json& s) {
        return s["show"]["boxes"] == true && s["show"]["pairs"] == true && s["show"]["cells"] == true;
    });
}

TEST_F(Window, AClickCountsThatComesInTheFrameOfItsMovement) {
    open();
    const Json places = settled()["controls"];
    for (const auto& [tab, control] : {std::pair{"See", "Boxes"}, {"Table", "Launch"}, {"See", "Boxes"}}) {
        window->click(places[tab]);
        window->wait(control, [control = control](const Json& s) { return s["controls"].contains(control); });
    }
}

TEST_F(Window, ClicksOnThePanelDoWhatTheySay) {
    open();
    click("Boxes");
    window->wait("boxes", [](const Json& s) { return s["show"]["boxes"] == true; });
    click("Gravity");
    window->wait("no gravity", [](const Json& s) { return s["gravity"] == false; });
    click("custom.sleep");
    window->wait("the setting", [](const Json& s) { return s["engines"][0]["settings"]["sleep"] == "off"; });
    click("Overlay");
    wait_for_view("overlay");
    click("Launch");
    wait_for_balls();
    click("Clear");
    window->wait("an empty table", [](const Json& s) {
        return s["panes"][0]["balls"].empty() && s["panes"][1]["balls"].empty();
    });
    const double wide = window->now()["layout"]["panes"][0][2];
    window->key("F2");
    const Json folded = window->wait("the folded panel", [](const Json& s) { return s["panel"] == false; });
    EXPECT_GT(folded["layout"]["panes"][0][2], wide + 200);
}

TEST_F(Window, SlowMotionAndNudge) {
    open();
    launch();
    wait_for_balls();
    window->key("s");
    window->wait("slow motion", [](const Json& s) { return s["speed"] == 0.1; });
    const Json before = pause();
    window->key("n");
    const double speed = before["panes"][0]["balls"][0]["velocity"][1];
    const Json after = window->wait(
        "the nudge", [&](const Json& s) { return s["panes"][0]["balls"][0]["velocity"][1] != speed; });
    for (std::size_t i = 0; i < 2; ++i) {
        const Json &was = before["panes"][i]["balls"][0]["velocity"],
                   &is = after["panes"][i]["balls"][0]["velocity"];
        EXPECT_NEAR(is[1].get<double>() - was[1].get<double>(), 0.25, 1e-5);
        EXPECT_NEAR(is[0].get<double>(), was[0].get<double>(), 1e-5);
    }
}

TEST_F(Window, TheMouseZoomsPansAndFits) {
    open();
    const Json before = window->now();
    const double fitted = before["scale"];
    const Json pane = before["layout"]["panes"][0];
    window->click(pane);
    window->xdotool("click --repeat 3 4");
    window->wait("a zoom", [&](const Json& s) { return s["scale"] > 1.3 * fitted; });
    const Json center = window->now()["center"];
    window->xdotool("mousedown 1 mousemove_relative --sync 60 40 mouseup 1");
    window->wait("a pan", [&](const Json& s) { return distance(s["center"], center) > 0.02; });
    // Away from the first click, so that only this one is double.
    window->xdotool("mousemove_relative --sync -- -90 -70 click --repeat 2 --delay 60 1");
    window->wait("the fit",
                 [&](const Json& s) { return std::abs(s["scale"].get<double>() / fitted - 1) < 1e-9; });
}

TEST_F(Window, AScreenshotShowsBothTablesAndTheBallsWhereTheyAre) {
    open();
    launch();
    wait_for_balls();
    window->wait("half a second", [](const Json& s) { return s["time"] > 0.5; });
    pause();
    window->key("F12");
    const Json state = window->wait(
        "the screenshot", [](const Json& s) { return !s["last_screenshot"].get<std::string>().empty(); });
    sf::Image image;
    ASSERT_TRUE(image.loadFromFile(state["last_screenshot"].get<std::string>()));
    ASSERT_EQ(image.getSize().x, state["layout"]["window"][0]);
    ASSERT_EQ(image.getSize().y, state["layout"]["window"][1]);

    const sf::Color ground(0x14, 0x17, 0x1c);
    const sf::Color engines[] = {{0x56, 0xb4, 0xe9}, {0xe6, 0x9f, 0x00}};
    for (std::size_t i = 0; i < 2; ++i) {
        const Json &rect = state["layout"]["panes"][i], &header = state["layout"]["headers"][i];
        const auto at = [&](const Json& r, double x, double y) {
            return image.getPixel(static_cast<unsigned>(r[0].get<double>() + x),
                                  static_cast<unsigned>(r[1].get<double>() + y));
        };
        EXPECT_LT(difference(at(header, 5, 1), engines[i]), 12) << "the engine's colour over pane " << i;
        int drawn = 0, empty = 0;
        for (double y = 0; y < rect[3]; ++y)
            for (double x = 0; x < rect[2]; ++x) {
                const sf::Color pixel = at(rect, x, y);
                if (std::max({pixel.r, pixel.g, pixel.b}) < 0x50)  // the ground and its lines
                    ++empty;
                else
                    ++drawn;
            }
        EXPECT_GT(drawn, 4000) << "pane " << i;
        EXPECT_GT(empty, drawn) << "pane " << i;
        for (const Json& ball : state["panes"][i]["balls"]) {
            const Json& center = ball["pixel"];
            const sf::Color steel = image.getPixel(center[0].get<unsigned>(), center[1].get<unsigned>());
            EXPECT_GT(difference(steel, ground), 150) << "ball " << ball;
            EXPECT_TRUE(ring_has(image, center, ball["pixel_radius"], engines[i])) << "rim of ball " << ball;
        }
    }
}

}  // namespace
}  // namespace flipside::app
