#include "plugin/world.hpp"

#include <chrono>

#include "lab/files/assets.hpp"
#include "lab/session/session.hpp"
#include "lab/statistics/median.hpp"
#include "places.hpp"
#include "plugin/needs.hpp"
#include "support.hpp"
#include "world/input_error.hpp"

namespace flipside::plugin {
namespace {

std::string problem_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(PluginEngine, ANameIsAWordThatNoOtherEngineHas) {
    // Its own name is "custom".
    const Engine& naughty = lab::engine_named(test::naughty_engine);
    EXPECT_EQ(naughty.name, "custom-2");
    EXPECT_EQ(&lab::engine_named("custom-2"), &naughty);
    EXPECT_EQ(&lab::engine_named(std::filesystem::path(test::naughty_engine).parent_path().string() + "/./" +
                                 std::filesystem::path(test::naughty_engine).filename().string()),
              &naughty);
    EXPECT_NE(&lab::engine_named("custom"), &naughty);
    EXPECT_EQ(lab::engine_named(test::engine_in_c).name, "engine-in-c");
    EXPECT_EQ(lab::engine_named(test::engine_in_c).settings.size(), 1U);
}

TEST(PluginEngine, WhatIsNoEngineIsBadInput) {
    const auto problem = [](const std::string& file) {
        return problem_of([&] { static_cast<void>(lab::engine_named(file)); });
    };
    EXPECT_NE(problem(test::not_an_engine).find("does not export flipside_engine_entry"), std::string::npos);
    EXPECT_NE(problem(test::later_engine).find("is of version 2 of the interface; allowed is 1"),
              std::string::npos);
    EXPECT_NE(problem(test::mute_engine).find("declares sensors or gates, but has no events"),
              std::string::npos);
    EXPECT_NE(problem("./nothing-there.so").find("cannot be read (No such file or directory)"),
              std::string::npos);
    EXPECT_NE(problem(test::source("README.md")).find("cannot be loaded"), std::string::npos);
    EXPECT_NE(problem("naughty").find("unknown engine 'naughty'"), std::string::npos);
}

TEST(PluginWorld, ASceneThatNeedsMoreIsRefusedByTheNamesOfWhatItNeeds) {
    const auto pinball = std::make_shared<const Scene>(load_scene(lab::scene_file("pinball")));
    const std::string problem = problem_of([&] { static_cast<void>(world_of(test::engine_in_c, pinball)); });
    for (const char* need : {"arcs (part \"arch\")", "gates (part \"gate\")",
                             "moving parts (part \"flipper-left\")", "friction (", "sensors (", "damping ("})
        EXPECT_NE(problem.find(need), std::string::npos) << problem;
    EXPECT_EQ(problem.find("several balls"), std::string::npos) << problem;
}

TEST(PluginNeeds, LayersAreNeededWhereTwoThingsDoNotMeet) {
    const auto missing = [](const std::string& rest) {
        const auto scene = scene_of(rest);
        return missing_features(*scene, surface_of(*scene), ~(FLIPSIDE_LAYERS | FLIPSIDE_FRICTION));
    };
    const std::string ball =
        R"("balls": [{"position": [0, 0], "radius": 1, "mass": 1, "material": "rough"}], )";
    const std::string rough = R"("materials": {"rough": {"friction": 1}}, )";
    const std::string part = R"("parts": [{"name": "pin", "shape": {"type": "point", "at": [5, 0]})";
    EXPECT_EQ(missing(rough + ball + part + "}]"), "");
    EXPECT_EQ(missing(rough + ball + part + R"(, "collides_with": []}])"), R"(layers (part "pin"))");
    EXPECT_EQ(missing(rough + ball + part + R"(, "material": "rough"}])"), R"(friction (part "pin"))");
}

TEST(PluginWorld, AnEngineWithoutControlsIsMadeAnewForThem) {
    const auto world = world_of(test::naughty_engine, falling(2));
    world->step(0.5);
    world->apply(control::Nudge{{2, 0}});
    Ball third = world->balls()[0];
    third.position = {5, 5};
    third.velocity = {};
    EXPECT_EQ(world->add(third), 2U);
    EXPECT_TRUE(world->remove(0));
    EXPECT_FALSE(world->remove(0));
    world->step(0.5);
    ASSERT_EQ(world->balls().size(), 2U);
    EXPECT_EQ(world->balls()[0].number, 1U);
    EXPECT_NEAR(world->balls()[0].position.x, 1 + 0.5 * 2, 1e-12);
    EXPECT_NEAR(world->balls()[0].position.y, 1 - 10.0 / 2, 1e-12);
    EXPECT_NEAR(world->balls()[1].position.y, 5 - 10 * 0.25 / 2, 1e-12);
}

TEST(PluginWorld, ABallThatLeavesTheBoundsIsLostOnce) {
    const auto world = world_of(test::naughty_engine, falling(2));
    std::size_t lost = 0;
    for (int i = 0; i < 60; ++i) {
        world->step(0.1);
        for (const Event& event : world->events()) lost += event.kind == EventKind::lost;
    }
    EXPECT_EQ(lost, 2U);
    EXPECT_TRUE(world->balls().empty());
}

TEST(PluginWorld, ASaveGoesOnInAnotherEngine) {
    const auto scene =
        scene_of(R"("gravity": [0, -10], "balls": [{"position": [0, 1], "radius": 0.1, "mass": 1}],
        "parts": [{"name": "floor", "shape": {"type": "segment", "a": [-5, 0], "b": [5, 0]}}])");
    const auto foreign = world_of(test::engine_in_c, scene);
    const auto exact = world_of("reference", scene);
    for (int i = 0; i < 25; ++i) foreign->step(0.01);
    exact->restore(foreign->save());
    EXPECT_EQ(exact->balls()[0], foreign->balls()[0]);
    foreign->step(0.01);
    exact->step(0.01);
    EXPECT_NEAR(exact->balls()[0].position.y, foreign->balls()[0].position.y, 1e-12);
}

TEST(PluginSession, TheTimeOfAStepIsThatOfTheEnginesProcess) {
    const auto scene = falling(2);
    const Engine& engine = lab::engine_named(test::naughty_engine);
    lab::Session session(scene, engine, Settings(engine.settings));
    double sum = 0;
    std::vector<double> engine_seconds, all_seconds;
    for (int i = 0; i < 101; ++i) {
        const auto start = std::chrono::steady_clock::now();
        session.step(0.001);
        all_seconds.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        engine_seconds.push_back(session.world().statistics().cpu_seconds.value());
        sum += engine_seconds.back();
    }
    EXPECT_DOUBLE_EQ(session.totals().step_seconds, sum);
    // Most of a step with two balls is the way to the other process and back.
    EXPECT_LT(lab::median_of(engine_seconds).value, 0.5 * lab::median_of(all_seconds).value);
}

TEST(PluginWorld, ATraceShowsWhatThereIsToSee) {
    const auto world = world_of(test::naughty_engine, falling(1));
    Trace trace;
    world->trace(&trace);
    world->step(0.5);
    ASSERT_EQ(trace.stages.size(), 3U);
    EXPECT_NE(trace.stages[1].says.find("Not visible from outside"), std::string::npos);
    ASSERT_EQ(trace.stages[1].items.size(), 1U);
    EXPECT_EQ(trace.stages[1].items[0].get<Vec2>("velocity_before"), (Vec2{0, 1}));
    EXPECT_EQ(trace.stages[1].items[0].get<Vec2>("velocity"), (Vec2{0, -4}));
}

}  // namespace
}  // namespace flipside::plugin
