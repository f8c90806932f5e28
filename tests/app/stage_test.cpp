#include "app/window/stage.hpp"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "world/input_error.hpp"

namespace flipside::app {
namespace {

std::vector<std::string> engines_of(const Stage& stage) {
    std::vector<std::string> names;
    for (const auto& run : stage.runs()) names.emplace_back(run.engine().name);
    return names;
}

using Names = std::vector<std::string>;

Stage stage_of(View view, const std::string& engine = "custom", const std::string& scene = "drop") {
    return {scene, engine, view, {}, {}};
}

const Divergence& between(const Stage& stage, std::string_view a, std::string_view b) {
    for (const Divergence& divergence : stage.divergences())
        if (divergence.is_of(a) && divergence.is_of(b)) return divergence;
    throw std::runtime_error("no such pair");
}

TEST(Stage, TheReferenceJoinsAndLeavesWithoutTouchingTheOthers) {
    Stage stage = stage_of(View::split);
    EXPECT_EQ(engines_of(stage), (Names{"custom", "box2d"}));
    EXPECT_EQ(stage.divergences().size(), 1U);
    for (int i = 0; i < 5; ++i) stage.step();
    stage.show_reference(true);
    ASSERT_EQ(engines_of(stage), (Names{"custom", "box2d", "reference"}));
    EXPECT_EQ(stage.divergences().size(), 3U);
    EXPECT_EQ(between(stage, "custom", "box2d").history().size(), 5U);
    EXPECT_TRUE(between(stage, "custom", "reference").history().empty());
    EXPECT_EQ(stage.runs()[2].session().world().time(), stage.time());
    EXPECT_EQ(stage.runs()[2].session().world().balls()[0].position,
              stage.runs()[0].session().world().balls()[0].position);
    stage.step();
    EXPECT_EQ(between(stage, "custom", "reference").history().size(), 1U);
    stage.show_reference(false);
    EXPECT_EQ(engines_of(stage), (Names{"custom", "box2d"}));
    EXPECT_EQ(between(stage, "custom", "box2d").history().size(), 6U);
}

TEST(Stage, TheReferenceMayLead) {
    Stage stage = stage_of(View::split, "reference");
    EXPECT_TRUE(stage.reference());
    EXPECT_EQ(engines_of(stage), (Names{"reference", "custom", "box2d"}));
    stage.set_view(View::single);
    EXPECT_EQ(engines_of(stage), (Names{"reference"}));
    stage.show_reference(false);
    EXPECT_EQ(engines_of(stage), (Names{"custom"}));
    stage.show_reference(true);
    EXPECT_EQ(engines_of(stage), (Names{"custom", "reference"}));
    stage.switch_engine();
    EXPECT_EQ(engines_of(stage), (Names{"box2d", "reference"}));
    stage.set_view(View::overlay);
    EXPECT_EQ(engines_of(stage), (Names{"box2d", "custom", "reference"}));
}

TEST(Stage, AloneTheReferenceGivesWayToTheNextEngine) {
    Stage stage = stage_of(View::single, "reference");
    EXPECT_EQ(engines_of(stage), (Names{"reference"}));
    for (int i = 0; i < 5; ++i) stage.step();
    const Vec2 before = stage.runs()[0].session().world().balls()[0].position;
    stage.switch_engine();
    EXPECT_EQ(engines_of(stage), (Names{"custom", "reference"}));
    for (const auto& run : stage.runs())
        EXPECT_LT(length(run.session().world().balls()[0].position - before), 1e-12);
}

TEST(Stage, EnginesChangePlacesAndAllGoOnFromTheFirst) {
    Stage stage = stage_of(View::split);
    stage.show_reference(true);
    for (int i = 0; i < 40; ++i) stage.step();
    const Vec2 first = stage.runs()[0].session().world().balls()[0].position;
    stage.switch_engine();
    EXPECT_EQ(engines_of(stage), (Names{"box2d", "custom", "reference"}));
    // Whoever parts from the reference now does so by itself.
    for (const auto& run : stage.runs())
        EXPECT_LT(length(run.session().world().balls()[0].position - first), 1e-6);
    stage.step();
    EXPECT_LT(between(stage, "custom", "reference").history().back().value, 1e-6);
    stage.show_reference(false);
    EXPECT_EQ(engines_of(stage), (Names{"box2d", "custom"}));
    stage.switch_engine();
    EXPECT_EQ(engines_of(stage), (Names{"custom", "box2d"}));
}

TEST(Stage, TheReferenceHasATwinUnlessTheUserSaysOtherwise) {
    const Stage with{"drop", "reference", View::single, {}, {}};
    EXPECT_EQ(with.runs()[0].session().settings().text("twin"), "on");
    const Stage without{"drop", "reference", View::single, {"reference.twin=off"}, {}};
    EXPECT_EQ(without.runs()[0].session().settings().text("twin"), "off");
}

Stage stage_with(const std::vector<std::string>& contenders) {
    return {"drop", "custom", View::split, {}, {}, contenders};
}

TEST(Stage, OneEngineTwiceWithItsOwnSettingsAndSteps) {
    Stage stage = stage_with({"coarse=custom,solver=simple,dt=1/60", "fine=custom,solver=simple,dt=1/240",
                              "truth=reference,dt=1/60"});
    ASSERT_EQ(stage.runs().size(), 3U);
    EXPECT_EQ(stage.dt(), 1.0 / 60);
    EXPECT_EQ(stage.runs()[0].twin(), 0);
    EXPECT_EQ(stage.runs()[1].twin(), 1);
    EXPECT_EQ(stage.runs()[1].session().settings().choice("solver"), "simple");
    for (int i = 0; i < 12; ++i) stage.step();
    EXPECT_EQ(stage.runs()[0].session().totals().steps, 12U);
    EXPECT_EQ(stage.runs()[1].session().totals().steps, 48U);
    EXPECT_NEAR(stage.runs()[0].session().world().time(), stage.runs()[1].session().world().time(), 1e-15);
    EXPECT_EQ(stage.divergences().size(), 3U);
    // As a run of it alone, to the bit.
    auto alone = lab::Session(stage.runs()[1].session().shared_scene(), stage.runs()[1].engine(),
                              stage.runs()[1].session().settings());
    for (int i = 0; i < 48; ++i) alone.step(1.0 / 240);
    EXPECT_EQ(alone.world().balls()[0].position, stage.runs()[1].session().world().balls()[0].position);
}

TEST(Stage, ContendersComeGoAndChangeWhileTheyRun) {
    Stage stage = stage_of(View::split);
    for (int i = 0; i < 5; ++i) stage.step();
    stage.add_contender();
    stage.add_contender();
    ASSERT_EQ(stage.runs().size(), 4U);
    EXPECT_EQ(stage.runs()[3].name(), "box2d-3");
    EXPECT_THROW(stage.add_contender(), InputError);
    EXPECT_FALSE(stage.show_reference(true));
    stage.change_engine(2, lab::engine_named("custom"));
    EXPECT_EQ(stage.runs()[2].name(), "custom-2");
    stage.change_step(2, 1.0 / 960);
    EXPECT_EQ(stage.dt(), 1.0 / 60);
    EXPECT_THROW(stage.change_step(3, 1.0 / 97), InputError);
    EXPECT_EQ(stage.runs()[3].dt(), 1.0 / 60);
    const double before = stage.time();
    stage.step();
    EXPECT_EQ(stage.runs()[2].session().totals().steps, 16U);
    for (const auto& run : stage.runs()) EXPECT_NEAR(run.session().world().time(), before + 1.0 / 60, 1e-12);
    for (int i = 0; i < 3; ++i) stage.remove_contender(0);
    EXPECT_EQ(engines_of(stage), (Names{"box2d"}));
    EXPECT_THROW(stage.remove_contender(0), InputError);
    stage.change_step(0, 1.0 / 15);
    EXPECT_EQ(stage.dt(), 1.0 / 15);
    stage.open("box");
    EXPECT_EQ(engines_of(stage), (Names{"box2d"}));
    EXPECT_EQ(stage.dt(), 1.0 / 15);
}

TEST(Stage, AnotherStepTakesBackWhatTheReferenceHasBegun) {
    Stage stage("box", "custom", View::split, {}, {});
    stage.show_reference(true);
    while (stage.step_within(0)) ASSERT_LT(stage.time(), 1);
    ASSERT_TRUE(stage.under_way());
    const double before = stage.time();
    for (std::size_t i = 0; i < 3; ++i) {
        // Down to the shortest one by one: the longest decides.
        stage.change_step(i, 1.0 / 120);
    }
    stage.step();
    for (const auto& run : stage.runs()) EXPECT_NEAR(run.session().world().time(), before + 1.0 / 120, 1e-12);
}

TEST(Stage, ALessonsContendersLeaveWithIt) {
    Stage stage = stage_of(View::overlay);
    stage.add_contender();
    lab::Lesson lesson;
    lesson.name = "one";
    lesson.scene = std::make_shared<const Scene>(stage.scene());
    lesson.engines = {{"custom", &lab::engine_named("custom"), {}, {{"solver", "simple"}}}};
    stage.open(lesson);
    EXPECT_EQ(engines_of(stage), (Names{"custom"}));
    stage.switch_engine();
    EXPECT_EQ(engines_of(stage), (Names{"box2d"}));
    stage.open("drop");
    EXPECT_EQ(engines_of(stage), (Names{"custom", "box2d", "box2d"}));
    EXPECT_EQ(stage.view(), View::overlay);
    EXPECT_EQ(stage.runs()[0].session().settings().choice("solver"), "continuous");
}

TEST(Stage, TheReferenceAgreesWithCustomLongerThanBox2d) {
    Stage stage = stage_of(View::overlay);
    stage.show_reference(true);
    // Until about the first impact.
    for (int i = 0; i < 12; ++i) stage.step();
    EXPECT_LT(between(stage, "custom", "reference").history().back().value, 1e-9);
    EXPECT_GT(between(stage, "box2d", "reference").history().back().value, 1e-6);
    EXPECT_FALSE(stage.runs()[2].uncertainty_history().empty());
    EXPECT_LT(stage.runs()[2].uncertainty_history().back().value, 1e-9);
}

TEST(Stage, TakingUpAgainStartsTheReferenceFromTheFirstOfTheOthers) {
    Stage stage = stage_of(View::split, "box2d");
    stage.show_reference(true);
    for (int i = 0; i < 30; ++i) stage.step();
    ASSERT_EQ(engines_of(stage), (Names{"box2d", "custom", "reference"}));
    const Vec2 other = stage.runs()[1].session().world().balls()[0].position;
    ASSERT_TRUE(stage.can_take_up());
    stage.take_up();
    EXPECT_EQ(stage.runs()[2].session().world().balls()[0].position,
              stage.runs()[0].session().world().balls()[0].position);
    EXPECT_EQ(stage.runs()[1].session().world().balls()[0].position, other);
    EXPECT_TRUE(between(stage, "box2d", "reference").history().empty());
    EXPECT_FALSE(between(stage, "box2d", "custom").history().empty());
}

TEST(Stage, NothingIsTakenUpWithoutAReferenceOrWithoutAnotherRun) {
    Stage stage = stage_of(View::split, "box2d");
    EXPECT_FALSE(stage.can_take_up());
    EXPECT_NE(stage.guide(), nullptr);
    const Stage alone("box", "custom", View::single, {}, {}, {"reference=reference"});
    EXPECT_FALSE(alone.can_take_up());
    EXPECT_EQ(alone.guide(), nullptr);
}

TEST(Stage, WaitsForTheReferenceWithAllItsRunsAndWithWhatIsPressed) {
    Stage stage("box", "custom", View::split, {}, {});
    stage.show_reference(true);
    const auto time_of = [&](std::size_t run) { return stage.runs()[run].session().world().time(); };
    int portions = 0;
    // A step without events is done in one portion.
    while (portions == 0) {
        ASSERT_LT(stage.time(), 1);
        const double before = stage.time();
        for (; !stage.step_within(0); ++portions) {
            EXPECT_TRUE(stage.under_way());
            for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(time_of(i), before);
            if (portions == 0) stage.press(control::Nudge{{3, 0}});
            for (const auto& run : stage.runs()) EXPECT_TRUE(run.session().recording().controls().empty());
        }
    }
    EXPECT_FALSE(stage.under_way());
    for (const auto& run : stage.runs()) {
        ASSERT_EQ(run.session().recording().controls().size(), 1U);
        EXPECT_EQ(run.session().recording().controls()[0].time, stage.time());
    }
}

TEST(Stage, HidesTheReferenceInTheMiddleOfItsStep) {
    Stage stage("box", "custom", View::split, {}, {});
    stage.show_reference(true);
    while (stage.step_within(0)) ASSERT_LT(stage.time(), 1);
    stage.press(control::Nudge{{3, 0}});
    stage.show_reference(false);
    EXPECT_FALSE(stage.under_way());
    stage.step();
    for (const auto& run : stage.runs()) EXPECT_EQ(run.session().recording().controls().size(), 1U);
}

TEST(Stage, TheNextBallPartsAnew) {
    Stage stage = stage_of(View::split, "custom", "pinball");
    const auto play = [&](auto until) {
        for (int i = 0; i < 60 * 120 && !until(); ++i) stage.step();
        return until();
    };
    const auto empty = [&] {
        return std::ranges::all_of(stage.runs(),
                                   [](const auto& run) { return run.session().world().balls().empty(); });
    };
    const auto parted = [&] { return stage.divergences()[0].parting().has_value(); };
    ASSERT_TRUE(play([&] { return stage.time() > 0.5; }));
    stage.press(control::Launch{0.8, 1, 1});
    ASSERT_TRUE(play(parted));
    ASSERT_TRUE(play(empty));
    EXPECT_TRUE(parted());
    const double first = stage.divergences()[0].parting()->time;
    stage.press(control::Launch{0.8, 1, 1});
    stage.step();
    stage.step();
    EXPECT_FALSE(parted());
    ASSERT_TRUE(play(parted));
    EXPECT_GT(stage.divergences()[0].parting()->time, first + 1);
}

/// What is on show of every run.
std::vector<std::vector<Ball>> balls_of(const Stage& stage) {
    std::vector<std::vector<Ball>> all;
    for (const auto& run : stage.runs()) {
        const auto balls = run.session().world().balls();
        all.emplace_back(balls.begin(), balls.end());
    }
    return all;
}

TEST(Stage, GoesBackStepByStepOnAllRunsToTheBit) {
    Stage stage("pinball", "custom", View::split, {}, {}, {"a=custom", "b=box2d,dt=1/120", "c=reference"});
    stage.press(control::Launch{0.8, 2, 1});
    std::vector<std::vector<std::vector<Ball>>> shown{balls_of(stage)};
    for (int i = 0; i < 130; ++i) {
        if (i == 60) stage.press(control::Nudge{{0.1, 0}});
        if (i == 90) stage.change_setting(1, "velocity_iterations", 3);
        if (i == 100) stage.set_gravity(false);
        stage.step();
        shown.push_back(balls_of(stage));
    }
    const double end = stage.time();
    for (std::size_t i = shown.size() - 1; i-- > 0;) {
        ASSERT_TRUE(stage.step_back());
        ASSERT_EQ(balls_of(stage), shown[i]) << i;
        EXPECT_TRUE(stage.in_past());
        EXPECT_EQ(stage.gravity(), i < 100);
    }
    EXPECT_FALSE(stage.step_back());
    EXPECT_EQ(stage.time(), 0);
    for (std::size_t i = 1; i < shown.size(); ++i) {
        ASSERT_TRUE(stage.step_forward());
        ASSERT_EQ(balls_of(stage), shown[i]) << i;
    }
    EXPECT_FALSE(stage.step_forward());
    EXPECT_FALSE(stage.in_past());
    EXPECT_EQ(stage.time(), end);
}

TEST(Stage, WhatIsDoneInThePastForgetsWhatCameAfter) {
    Stage stage("toy", "custom", View::split, {}, {});
    stage.press(control::Launch{0.8, 1, 1});
    for (int i = 0; i < 60; ++i) stage.step();
    const auto end = balls_of(stage);
    stage.go_to(0.5);
    EXPECT_NEAR(stage.time(), 0.5, 1e-9);
    EXPECT_NEAR(stage.record_end(), 1, 1e-9);
    stage.step();
    EXPECT_NEAR(stage.record_end(), stage.time(), 1e-9);
    EXPECT_FALSE(stage.in_past());
    for (int i = 0; i < 29; ++i) stage.step();
    EXPECT_EQ(balls_of(stage)[0], end[0]);  // the same ball falls the same way on custom
    stage.go_to(0.5);
    stage.press(control::Nudge{{0.3, 0.1}});
    EXPECT_NEAR(stage.record_end(), 0.5, 1e-9);
    for (int i = 0; i < 30; ++i) stage.step();
    EXPECT_NE(balls_of(stage)[0], end[0]);
    EXPECT_LE(stage.divergences()[0].history().size(), 61U);
}

class RefusedStage : public testing::Test {
  protected:
    void SetUp() override {
        std::ofstream(file) << R"({"format": "flipside-scene/1", "name": "pile", "about": "One on the other.",
            "bounds": {"min": [-1, -1], "max": [1, 1]}, "gravity": [0, -9.81],
            "balls": [{"position": [0, 0.1], "radius": 0.1, "mass": 1},
                      {"position": [0, 0.4], "radius": 0.1, "mass": 1},
                      {"position": [0, 0.9], "radius": 0.1, "mass": 1}],
            "materials": {"soft": {"restitution": 0}},
            "parts": [{"name": "floor", "material": "soft",
                       "shape": {"type": "segment", "a": [-1, 0], "b": [1, 0]}}]})";
    }
    void TearDown() override { std::filesystem::remove(file); }

    std::string file = testing::TempDir() + "flipside-pile-" + std::to_string(getpid()) + ".json";
};

TEST_F(RefusedStage, TheOthersGoOnAndTheReferenceIsTakenUpWhereTheyAre) {
    Stage stage = stage_of(View::overlay, "custom", file);
    stage.show_reference(true);
    for (int i = 0; i < 60; ++i) stage.step();
    const auto& exact = stage.runs()[2];
    ASSERT_TRUE(exact.halt());
    EXPECT_NE(exact.halt()->reason.find("in resting contact"), std::string::npos) << exact.halt()->reason;
    EXPECT_LT(exact.halt()->time, 0.5);
    EXPECT_NEAR(stage.time(), 1, 1e-9);
    EXPECT_LE(between(stage, "custom", "reference").history().back().time, exact.halt()->time + 1e-9);
    EXPECT_NEAR(between(stage, "custom", "box2d").history().back().time, 1, 1e-9);
    const double halted = exact.halt()->time;
    stage.go_to(0);
    EXPECT_FALSE(exact.halt());
    EXPECT_EQ(exact.session().world().time(), 0);
    stage.go_to(0.9);
    ASSERT_TRUE(exact.halt());
    EXPECT_EQ(exact.halt()->time, halted);
    stage.go_to(1);
    stage.take_up();
    EXPECT_FALSE(stage.runs()[2].halt());
    EXPECT_NEAR(stage.runs()[2].session().world().time(), 1, 1e-9);
    stage.step();
    stage.clear();
    stage.step();
    EXPECT_FALSE(stage.runs()[2].halt());
    for (const auto& run : stage.runs()) EXPECT_NEAR(run.session().world().time(), stage.time(), 1e-12);
}

}  // namespace
}  // namespace flipside::app
