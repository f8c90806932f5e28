/// Experiments of which one contender does not get to the end.

#include <gtest/gtest.h>

#include "lab/comparison/compare.hpp"
#include "lab/session/session.hpp"
#include "lab/sweep/contenders.hpp"
#include "lab/sweep/unit.hpp"
#include "places.hpp"
#include "support.hpp"
#include "world/input_error.hpp"

namespace flipside::plugin {
namespace {

lab::Contender contender(const char* engine, const Scene& scene, const std::string& change = "") {
    const Engine& is = lab::engine_named(engine);
    lab::ContenderRequest request = lab::plain_contender(is);
    if (!change.empty()) request.set.emplace_back("does", change);
    return lab::contender_for(request, scene, 0.01);
}

TEST(PluginCompare, OneThatCrashesEndsAloneAndByName) {
    lab::CompareInput input;
    input.scene = falling(1);
    input.contenders = {contender("custom", *input.scene),
                        contender(test::naughty_engine, *input.scene, "crash"),
                        contender("box2d", *input.scene)};
    input.seconds = 0.5;
    const lab::Comparison comparison = lab::compare(input);
    EXPECT_FALSE(comparison.runs[0].ended);
    EXPECT_FALSE(comparison.runs[2].ended);
    ASSERT_TRUE(comparison.runs[1].ended);
    EXPECT_NEAR(comparison.runs[1].ended->time, 0.1, 1e-9);
    EXPECT_NE(comparison.runs[1].ended->why.find("has crashed"), std::string::npos);
    EXPECT_NEAR(comparison.runs[1].figures.sim_seconds, 0.1, 1e-9);
    EXPECT_EQ(comparison.pairs[0].radii.size(), 10U);
    EXPECT_EQ(comparison.pairs[1].radii.size(), 50U);
    EXPECT_EQ(comparison.times.size(), 50U);
    EXPECT_NE(to_json(comparison).find("has crashed"), std::string::npos);
}

TEST(PluginSession, BesideOthersAnEngineThatCannotRunASceneRefusesItsFirstStep) {
    const auto bowl = std::make_shared<const Scene>(load_scene(test::source("assets/scenes/bowl.json")));
    const Engine& engine = lab::engine_named(test::engine_in_c);
    EXPECT_THROW(lab::Session(bowl, engine, Settings(engine.settings)), InputError);
    lab::Session session(bowl, engine, Settings(engine.settings), lab::WithoutWorld::refuse_steps);
    EXPECT_EQ(session.world().balls().size(), bowl->balls.size());
    EXPECT_THROW(session.step(0.01), Refusal);
    // On a scene that it can run it goes on.
    const Engine& exact = lab::engine_named("reference");
    session.change(bowl, exact, Settings(exact.settings));
    session.step(0.01);
    EXPECT_NEAR(session.world().time(), 0.01, 1e-12);
}

namespace sweep = lab::sweep;

TEST(PluginSweep, WhatAnEngineCannotRunFailsInItsOwnRunsOnly) {
    const auto scene = std::make_shared<const Scene>(load_scene(test::source("assets/scenes/bowl.json")));
    sweep::Plan plan;
    plan.variants = {{.name = "bowl", .scene = "bowl", .balls = 0, .from = 0, .until = 1}};
    plan.contenders = {&sweep::contender_named("custom-continuous"),
                       &sweep::contender_named(test::engine_in_c)};
    plan.repetitions = 1;
    plan.finest = 60;
    sweep::Block block;
    sweep::Window window;
    window.start.balls = scene->balls;
    window.start.parts.resize(scene->parts.size());
    window.start.next_number = 1;
    window.seconds = 0.1;
    window.ends = {{0, scene->balls[0].position, scene->balls[0].radius, 0, true}};
    block.windows = {window};
    const sweep::Unit unit{plan.variants.data(), 0};
    const auto runs = sweep::measure_unit(plan, unit, block, scene, [](double) {});
    ASSERT_EQ(runs.size(), 4U);
    for (const sweep::Run& run : runs) {
        const bool foreign = run.contender == "engine-in-c";
        EXPECT_EQ(run.outcome.failure, foreign ? "refused" : "");
        EXPECT_EQ(run.outcome.why.find("needs what this engine does not support: arcs") != std::string::npos,
                  foreign);
    }
    // The plan names the library by its contents.
    EXPECT_NE(sweep::to_json(plan).find("file_xxh3"), std::string::npos);
    EXPECT_EQ(sweep::parse_plan(sweep::to_json(plan), "plan").contenders, plan.contenders);
}

}  // namespace
}  // namespace flipside::plugin
