/// The step bar in the real window, worked by keys and clicks.

#include "app/window/step_bar.hpp"
#include "app/window_fixture.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/traced_step.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {
namespace {

class MicroscopeWindow : public WindowTest {
  protected:
    /// Opens a scene at its very start, with the step bar.
    Json open_inside(const std::string& scene, const std::string& view,
                     const std::vector<std::string>& more = {}) {
        open(scene, view, "custom", more);
        pause();
        window->key("i");
        window->wait("the step bar", [](const Json& s) { return s["step_bar"] == true; });
        window->key("r");
        return window->wait("the start", [](const Json& s) { return s["time"] == 0; });
    }
    Json go_on_to(const std::string& key, std::size_t stage) {
        window->key(key);
        return window->wait("stage " + std::to_string(stage), [&](const Json& s) {
            return s.contains("inside") && s["inside"]["stage"] == stage;
        });
    }
};

/// The trace of the first step of a scene, as the window must show it.
lab::TracedStep first_step(const std::string& scene_name, std::string_view engine,
                           const std::vector<std::string>& changes) {
    const auto scene = std::make_shared<const Scene>(load_scene(lab::scene_file(scene_name)));
    const Engine& used = lab::engine_named(engine);
    const Engine* const one[] = {&used};
    lab::Session session(scene, used, lab::settings_for(used, *scene, lab::parse_changes(changes, one)));
    const Script nothing;
    std::size_t next = 0;
    return lab::trace_step(session, lab::step_for(*scene), nothing, next);
}

TEST(StepBar, GivesNumbersTheirUnits) {
    TraceItem item{"ball", {}};
    item.with("ball", 0U).with("next_time", 0.3968).with("separation", -0.02833).with("impulse", 0.4);
    item.with("overlap", true);
    EXPECT_EQ(in_one_line(item),
              "ball 0  next time 0.3968 s  separation −28.3 mm  impulse 400 mN·s  overlap yes");
}

TEST(StepBar, WhatSaysItselfWhatItIsHasNoNameBeforeIt) {
    TraceItem item{"path", {}};
    item.with("ball", 3U).with("way", "free flight").with("answer", "impact");
    EXPECT_EQ(in_one_line(item), "path  ball 3  free flight  impact");
}

TEST_F(MicroscopeWindow, WalksEveryStageOfAStepOnEveryEngineForthAndBack) {
    open_inside("box", "split", {"--set", "custom.solver=simple"});
    const std::pair<const char*, std::vector<std::string>> engines[] = {{"custom", {"solver=simple"}},
                                                                        {"box2d", {}}};
    Json state = go_on_to("period", 0);
    for (const auto& one : engines) {
        const std::string engine = one.first;
        const std::vector<std::string>& changes = one.second;
        SCOPED_TRACE(engine);
        const auto stages = first_step("box", engine, changes).trace.stages;
        ASSERT_GT(stages.size(), 5U);
        for (std::size_t k = 0; k < stages.size(); ++k) {
            if (k > 0) state = go_on_to("period", k);
            const Json& inside = state["inside"];
            EXPECT_EQ(inside["engine"], engine);
            EXPECT_EQ(inside["stages"], stages.size());
            EXPECT_EQ(inside["name"], stages[k].name);
            EXPECT_EQ(inside["says"], stages[k].says);
            EXPECT_EQ(inside["where"], stages[k].where);
            EXPECT_EQ(inside["items"], stages[k].items.size());
        }
        state = go_on_to("comma", stages.size() - 2);
        EXPECT_EQ(state["inside"]["name"], stages[stages.size() - 2].name);
        window->key("c");
        state =
            window->wait("the other engine", [&](const Json& s) { return s["inside"]["engine"] != engine; });
        EXPECT_EQ(state["inside"]["stage"], 0);
    }
    EXPECT_EQ(state["panes"][0]["steps"], 1);
    EXPECT_EQ(state["panes"][1]["steps"], 1);
}

TEST_F(MicroscopeWindow, BallsAreWhereTheStageHasThem) {
    const Json before = open_inside("box", "single",
                                    {"--set", "custom.solver=simple", "--set", "custom.motion_iterations=1"});
    const Json moved = go_on_to("period", 0);
    const auto trace = first_step("box", "custom", {"solver=simple", "motion_iterations=1"}).trace;
    ASSERT_EQ(trace.stages[0].items.size(), moved["inside"]["balls"].size());
    for (std::size_t i = 0; i < trace.stages[0].items.size(); ++i) {
        const Vec2 at = trace.stages[0].items[i].get<Vec2>("position");
        EXPECT_EQ(moved["inside"]["balls"][i]["position"][0], at.x);
        EXPECT_EQ(moved["inside"]["balls"][i]["position"][1], at.y);
        EXPECT_NE(before["panes"][0]["balls"][i]["position"][0], at.x);
    }
}

TEST_F(MicroscopeWindow, ItemsArePickedByKeyAndByClick) {
    open_inside("box", "single", {"--set", "custom.solver=simple"});
    go_on_to("period", 0);
    window->key("bracketright");
    Json state = window->wait("the second item", [](const Json& s) { return s["inside"]["item"] == 1; });
    EXPECT_NE(state["inside"]["picked"].get<std::string>().find("ball 1"), std::string::npos);
    click("item 3");
    window->wait("the third item", [](const Json& s) { return s["inside"]["item"] == 2; });
    window->key("bracketleft");
    window->wait("the second again", [](const Json& s) { return s["inside"]["item"] == 1; });
    click("stage 2");
    state = window->wait("the second stage", [](const Json& s) { return s["inside"]["stage"] == 1; });
    EXPECT_EQ(state["inside"]["name"], "broad phase");
    window->key("F12");
    window->wait("a picture", [](const Json& s) { return !s["last_screenshot"].get<std::string>().empty(); });
}

TEST_F(MicroscopeWindow, AWholeStepEndsAtItsReadOutAndShiftRaisesNoFlipper) {
    open_inside("pinball", "single");
    const Json before = window->now();
    window->key("shift+period");
    const Json after = window->wait("the read-out", [](const Json& s) {
        return s.contains("inside") && s["inside"]["name"] == "read-out";
    });
    EXPECT_EQ(after["panes"][0]["steps"], 1);
    EXPECT_EQ(after["panes"][0]["flippers"], before["panes"][0]["flippers"]);
    window->key("period");
    window->wait("the next step",
                 [](const Json& s) { return s["panes"][0]["steps"] == 2 && s["inside"]["stage"] == 0; });
    window->key("i");
    window->wait("no step bar",
                 [](const Json& s) { return s["step_bar"] == false && !s.contains("inside"); });
    window->key("period");
    window->wait("a plain step", [](const Json& s) { return s["panes"][0]["steps"] == 3; });
}

TEST_F(MicroscopeWindow, WhatHappensOtherwiseEndsTheWalk) {
    open_inside("box", "split");
    go_on_to("period", 0);
    window->key("Tab");
    window->wait("the other engine first", [](const Json& s) { return s["panes"][0]["engine"] == "box2d"; });
    EXPECT_FALSE(window->now().contains("inside"));
    go_on_to("period", 0);
    window->key("p");
    const Json later = window->wait("time to go on", [](const Json& s) { return s["time"] > 0.3; });
    EXPECT_FALSE(later.contains("inside"));
}

}  // namespace
}  // namespace flipside::app
