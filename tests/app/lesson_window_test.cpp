/// The lessons in the real window, worked by keys and clicks.

#include "app/window_fixture.hpp"
#include "lab/lessons/lesson.hpp"

namespace flipside::app {
namespace {

using LessonWindow = WindowTest;

TEST_F(LessonWindow, AStrangerFollowsTheFirstLessonToItsEnd) {
    open("pinball", "split");
    const Json before = window->now();
    click("Lesson");
    click("01  One frame");
    Json state = window->wait("the lesson", [](const Json& s) { return s.contains("lesson"); });
    EXPECT_EQ(state["lesson"]["title"], "One frame");
    EXPECT_EQ(state["scene"], "lesson 01-one-frame");
    EXPECT_EQ(state["view"], "single");
    EXPECT_EQ(state["step_bar"], true);
    EXPECT_EQ(state["paused"], true);
    for (const char* stage : {"move", "broad phase", "narrow phase", "response"}) {
        window->key("period");
        window->wait(stage,
                     [&](const Json& s) { return s.contains("inside") && s["inside"]["name"] == stage; });
    }
    click("Move and response");
    state = window->wait("the answer", [](const Json& s) { return s["lesson"]["answered"].is_number(); });
    EXPECT_EQ(state["lesson"]["answered"], 1);
    click("Check it");
    state = window->wait("the check", [](const Json& s) { return s["lesson"].contains("holds"); });
    for (const Json& holds : state["lesson"]["holds"]) EXPECT_EQ(holds, true);
    click("Next");
    state = window->wait("the next lesson",
                         [](const Json& s) { return s["lesson"]["name"] == "02-which-pairs"; });
    EXPECT_EQ(state["show"]["pairs"], true);
    EXPECT_EQ(state["step_bar"], false);
    click("All lessons");
    state = window->wait("the list", [](const Json& s) { return !s.contains("lesson"); });
    EXPECT_EQ(state["show"], before["show"]);
    EXPECT_EQ(state["step_bar"], before["step_bar"]);
}

TEST_F(LessonWindow, WhatWorksALessonStaysInSightWhileItsTextIsScrolled) {
    open("pinball", "split", "custom", {"--lesson", "9", "--height", "640"});
    window->wait("the lesson", [](const Json& s) { return s.contains("lesson"); });
    Json state = settled();
    const Json panel = state["layout"]["panel"];
    for (int i = 0; i < 2; ++i) {
        for (const char* control : {"Lesson", "All lessons", "Begin again", "Back", "Next", "Check it"})
            EXPECT_TRUE(state["controls"].contains(control)) << control;
        window->xdotool("mousemove " + std::to_string(panel[0].get<int>() + panel[2].get<int>() / 2) + ' ' +
                        std::to_string(panel[1].get<int>() + panel[3].get<int>() / 2) +
                        " click --repeat 30 5");
        state = settled();
    }
}

TEST_F(LessonWindow, ALessonChoosesItsViewAndItsPlotsAndGivesThemBack) {
    open("pinball", "split", "custom", {"--lesson", "19"});
    Json state = window->wait("the lesson", [](const Json& s) { return s.contains("lesson"); });
    EXPECT_EQ(state["view"], "overlay");
    EXPECT_EQ(state["plots"], "Distance");
    EXPECT_EQ(state["panes"].size(), 3U);
    click("Next");
    state = window->wait("the next lesson",
                         [](const Json& s) { return s["lesson"]["name"] == "20-what-a-digit-costs"; });
    EXPECT_EQ(state["view"], "split");
    EXPECT_EQ(state["plots"], "Distance and cost");
    click("All lessons");
    state = window->wait("the list", [](const Json& s) { return !s.contains("lesson"); });
    EXPECT_EQ(state["plots"], "Distance and energy");
}

TEST_F(LessonWindow, APauseThatALessonBeginsWithEndsWithIt) {
    open("pinball", "split", "custom", {"--lesson", "1"});
    window->wait("the pause", [](const Json& s) { return s["paused"] == true; });
    click("All lessons");
    const Json state = window->wait("the list", [](const Json& s) { return !s.contains("lesson"); });
    EXPECT_EQ(state["paused"], false);
}

TEST_F(LessonWindow, EveryLessonOpensAndRunsOnItsEngines) {
    const auto files = lab::lesson_files();
    for (const auto& file : files) {
        SCOPED_TRACE(file.string());
        const lab::Lesson lesson = lab::load_lesson(file);
        open("pinball", "split", "custom", {"--lesson", file.string()});
        const Json state = window->wait("the lesson", [](const Json& s) { return s.contains("lesson"); });
        EXPECT_EQ(state["lesson"]["name"], lesson.name);
        ASSERT_GE(state["panes"].size(), lesson.view == lab::LessonView::single ? 1U : 2U);
        EXPECT_EQ(state["panes"][0]["engine"], lesson.engines[0].engine->name);
        EXPECT_FALSE(state["panes"][0]["balls"].empty());
        for (const Json& pane : state["panes"]) EXPECT_TRUE(pane["halted"].is_null());
        for (const auto& [name, value] : lesson.engines[0].set)
            EXPECT_EQ(state["engines"][0]["settings"][name], value);
        TearDown();
    }
}

}  // namespace
}  // namespace flipside::app
