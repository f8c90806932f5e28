#include "lab/session/traced_step.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

#include <gtest/gtest.h>

#include "lab/engines/every_solver.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/run_settings.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"
#include "world/schema.hpp"
#include "world/state_file.hpp"
#include "world/trace_units.hpp"

namespace flipside::lab {
namespace {

constexpr double dt = 1.0 / 60;

const TraceItem* find(const TraceStage& stage, const std::string& kind) {
    const auto at = std::ranges::find(stage.items, kind, &TraceItem::kind);
    return at == stage.items.end() ? nullptr : &*at;
}

/// What a trace must be, whatever the engine.
void expect_sound(const TracedStep& step, const World& after) {
    const Trace& trace = step.trace;
    ASSERT_FALSE(trace.stages.empty());
    for (const TraceStage& stage : trace.stages) {
        EXPECT_FALSE(stage.name.empty());
        EXPECT_FALSE(stage.where.empty());
        EXPECT_TRUE(stage.says.ends_with('.')) << stage.name << ": " << stage.says;
    }
    const TraceStage& last = trace.stages.back();
    EXPECT_EQ(last.name, "read-out");
    std::size_t told = 0;
    for (const TraceItem& item : last.items) {
        if (item.kind != "ball") continue;
        const Ball& ball = after.balls()[told++];
        EXPECT_EQ(item.get<std::int64_t>("ball"), std::int64_t{ball.number});
        EXPECT_EQ(item.get<Vec2>("position"), ball.position);
        EXPECT_EQ(item.get<Vec2>("velocity"), ball.velocity);
        EXPECT_EQ(item.get<double>("spin"), ball.spin);
        EXPECT_EQ(item.get<double>("angle"), ball.angle);
    }
    EXPECT_EQ(told, after.balls().size());
    constexpr std::string_view without_unit[] = {"normal",      "axis",     "along",     "clamped",
                                                 "restitution", "friction", "area_ratio"};
    for (const TraceStage& stage : trace.stages)
        for (const TraceItem& item : stage.items)
            for (const auto& [name, value] : item.fields)
                if (std::holds_alternative<double>(value) || std::holds_alternative<Vec2>(value)) {
                    const bool has_none = std::ranges::find(without_unit, name) != std::end(without_unit);
                    EXPECT_EQ(unit_of(name, value).empty(), has_none) << stage.name << ": " << name;
                }
    const std::string text = to_text(step);
    for (const TraceStage& stage : trace.stages) EXPECT_NE(text.find(stage.says), std::string::npos);
}

void expect_fits_schema(const TracedStep& step) {
    EXPECT_NO_THROW(check_form(parse_json(to_json(step), "trace"), trace_schema, "trace"));
}

TEST(TracedStep, OfEveryEngineIsSoundAndChangesNoBit) {
    for (const auto& [engine, settings] : every_solver())
        for (const std::string& name : scene_names()) {
            SCOPED_TRACE(std::string(engine->name) + " on " + name);
            const auto scene = std::make_shared<const Scene>(load_scene(scene_file(name)));
            Session traced(scene, *engine, settings), plain(scene, *engine, settings);
            if (scene->launcher) traced.apply(control::Launch{1}), plain.apply(control::Launch{1});
            const Script nothing;
            std::size_t next = 0;
            try {
                for (int k = 0; k < 100; ++k) {
                    plain.step(dt);
                    if (k % 25 != 0) {
                        traced.step(dt);
                        continue;
                    }
                    const TracedStep step = trace_step(traced, dt, nothing, next);
                    expect_sound(step, traced.world());
                    // The check of a form takes long.
                    if (k == 50 && scene->balls.size() < 50) expect_fits_schema(step);
                }
            } catch (const Refusal&) {
                EXPECT_EQ(engine->name, "reference");
                continue;
            }
            EXPECT_EQ(to_json(traced.world().save(), *scene), to_json(plain.world().save(), *scene));
        }
}

std::shared_ptr<const Scene> one_bounce() {
    return std::make_shared<const Scene>(parse_scene(R"({"format": "flipside-scene/1", "name": "bounce",
        "bounds": {"min": [-2, -2], "max": [2, 2]}, "gravity": [0, 0],
        "materials": {"half": {"restitution": 0.5}, "whole": {"restitution": 1}},
        "balls": [{"position": [0, 0.105], "velocity": [0, -1], "radius": 0.1, "mass": 2, "material": "whole"},
                  {"position": [1, 1], "radius": 0.1, "mass": 1}],
        "parts": [{"name": "floor", "material": "half",
                   "shape": {"type": "segment", "a": [-1, 0], "b": [1, 0]}}]})",
                                                     "bounce"));
}

TracedStep bounce_on(std::string_view engine, const std::vector<std::string>& changes = {}) {
    const Engine& used = engine_named(engine);
    const Engine* const one[] = {&used};
    Session session(one_bounce(), used, settings_for(used, *one_bounce(), parse_changes(changes, one)));
    const Script nothing;
    std::size_t next = 0;
    return trace_step(session, dt, nothing, next);
}

/// The impact of the ball on the floor, wherever the engine says it.
const TraceItem& impact_in(const TracedStep& step) {
    for (const TraceStage& stage : step.trace.stages)
        for (const TraceItem& item : stage.items)
            if (const TraceValue* answer = item.find("answer"))
                if (*answer == TraceValue(std::string("impact"))) return item;
    throw std::runtime_error("no impact in the trace");
}

TEST(TracedStep, TellsOfAnImpactWithItsNumbers) {
    for (const TracedStep& step :
         {bounce_on("custom"), bounce_on("custom", {"solver=simple"}), bounce_on("reference")}) {
        SCOPED_TRACE(to_text(step));
        const TraceItem& impact = impact_in(step);
        EXPECT_EQ(impact.get<std::int64_t>("ball"), 0);
        EXPECT_EQ(impact.get<std::string>("part"), "floor");
        EXPECT_NEAR(impact.get<double>("speed"), 1, 1e-12);
        EXPECT_NEAR(impact.get<double>("impulse"), 2 * 1.5, 1e-12);
        EXPECT_NEAR(impact.get<Vec2>("velocity_before").y, -1, 1e-12);
        EXPECT_NEAR(impact.get<Vec2>("velocity").y, 0.5, 1e-12);
        EXPECT_EQ(impact.get<Vec2>("normal"), (Vec2{0, 1}));
    }
}

TEST(TracedStep, OfEventsTellsWhenAndHowSurely) {
    for (const char* engine : {"custom", "reference"}) {
        const TracedStep step = bounce_on(engine);
        EXPECT_NEAR(impact_in(step).get<double>("time"), 0.005, 1e-12) << engine;
    }
    const double width = impact_in(bounce_on("reference")).get<double>("isolated_within");
    EXPECT_GT(width, 0);
    EXPECT_LT(width, 1e-14);
}

TEST(TracedStep, OfBox2DTellsWhatItsListenerSees) {
    const TracedStep step = bounce_on("box2d");
    std::vector<std::string> names;
    for (const TraceStage& stage : step.trace.stages) names.push_back(stage.name);
    EXPECT_EQ(names, (std::vector<std::string>{"gravity and drag", "narrow phase (Collide)",
                                               "velocity solver", "position solver",
                                               "broad phase (dynamic tree)", "time of impact", "read-out"}));
    // The ball is above the floor when the step begins: Box2D meets it in a sub-step to the time of impact.
    const TraceItem* impulse = find(step.trace.stages[5], "impulse");
    ASSERT_NE(impulse, nullptr) << to_text(step);
    EXPECT_NEAR(impulse->get<double>("impulse"), 3, 1e-3);
    EXPECT_EQ(impulse->get<std::string>("part"), "floor");
}

TEST(TracedStep, OfBox2DTellsTheTimeOfImpactFromTheWayThatABallHasCome) {
    const TracedStep step = bounce_on("box2d");
    const TraceItem* manifold = find(step.trace.stages[5], "manifold");
    ASSERT_NE(manifold, nullptr) << to_text(step);
    // At 1 m/s the ball meets the floor after 5 ms; Box2D lets it go on until they overlap by some slops.
    const double overlap = -manifold->get<double>("separation");
    EXPECT_GT(overlap, 0);
    EXPECT_NEAR(manifold->get<double>("time_of_impact"), 0.005 + overlap, 1e-6);
    const auto& way = manifold->get<std::vector<double>>("swept");
    EXPECT_NEAR(way[1], 0.105, 1e-6);
    EXPECT_EQ(way.back(), manifold->get<Vec2>("position").y);
}

TEST(TracedStep, OfBox2DTellsWhatIsVisibleOfItsTree) {
    const TraceStage tree = bounce_on("box2d").trace.stages[4];
    std::int64_t leaves = 0;
    for (const TraceItem& item : tree.items) {
        if (item.kind != "fat box") continue;
        ++leaves;
        const Box &fat = item.get<Box>("box"), &tight = item.get<Box>("tight_box");
        EXPECT_LT(fat.min.x, tight.min.x);
        EXPECT_LT(fat.min.y, tight.min.y);
        EXPECT_GT(fat.max.x, tight.max.x);
        EXPECT_GT(fat.max.y, tight.max.y);
    }
    const TraceItem* whole = find(tree, "tree");
    ASSERT_NE(whole, nullptr);
    EXPECT_GE(leaves, 3);  // two balls and the floor
    EXPECT_EQ(whole->get<std::int64_t>("leaves"), leaves);
    EXPECT_LE(leaves, std::int64_t{1} << (whole->get<std::int64_t>("levels") - 1));
    EXPECT_EQ(whole->get<std::string>("inner_nodes"), "not visible from outside");
}

TEST(TracedStep, PathsThatAreSweptEndWhereTheEventIs) {
    for (const char* engine : {"custom", "reference"}) {
        const TracedStep step = bounce_on(engine);
        SCOPED_TRACE(to_text(step));
        const TraceItem& impact = impact_in(step);
        const auto& way = impact.get<std::vector<double>>("swept");
        const Vec2 end = impact.get<Vec2>("position");
        EXPECT_NEAR(way[way.size() - 2], end.x, 1e-15);
        EXPECT_NEAR(way.back(), end.y, 1e-15);
        EXPECT_NEAR(way[1], 0.105, 1e-15);
        const TraceItem* path = find(step.trace.stages[0], "path");
        ASSERT_NE(path, nullptr);
        EXPECT_NEAR(path->get<std::vector<double>>("swept").back(), 0.1, 1e-12);
        if (engine == std::string("reference")) continue;
        EXPECT_NEAR(path->get<double>("gap"), 0.005, 1e-12);
        const auto& line = path->get<std::vector<double>>("gap_line");
        EXPECT_NEAR(line[1], 0.005, 1e-12) << "the lowest point of the ball";
        EXPECT_NEAR(line[3], 0, 1e-12) << "the floor";
    }
}

TEST(TracedStep, MayBeNarrowedToABall) {
    TracedStep step = bounce_on("custom", {"solver=simple"});
    keep_ball(step.trace, 1);
    const std::string text = to_text(step);
    EXPECT_NE(text.find("ball 1"), std::string::npos);
    EXPECT_EQ(text.find("move:  ball 0"), std::string::npos) << text;
}

TEST(TracedStep, OfSleepersSaysThatNothingIsDone) {
    const auto scene =
        std::make_shared<const Scene>(parse_scene(R"({"format": "flipside-scene/1", "name": "rest",
        "bounds": {"min": [-2, -2], "max": [2, 2]}, "gravity": [0, -9.8],
        "balls": [{"position": [0, 0.1], "radius": 0.1, "mass": 2}],
        "parts": [{"name": "floor", "shape": {"type": "segment", "a": [-1, 0], "b": [1, 0]}}]})",
                                                  "rest"));
    Session session(scene, engine_named("custom"), settings_for(engine_named("custom"), *scene));
    for (int k = 0; k < 60; ++k) session.step(dt);
    const Script nothing;
    std::size_t next = 0;
    const TracedStep step = trace_step(session, dt, nothing, next);
    EXPECT_EQ(step.trace.stages.front().name, "asleep");
    EXPECT_NE(step.trace.stages.front().says.find("nothing is done"), std::string::npos);
}

}  // namespace
}  // namespace flipside::lab
