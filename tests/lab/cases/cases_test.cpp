// The hard cases: event-ordered solvers pass all of them; time-stepping ones give whole tables.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "in_small.hpp"
#include "lab/cases/experiment.hpp"
#include "lab/contenders/engines.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {
namespace {

CaseInput contender(std::string_view engine, const std::vector<std::string>& settings = {}) {
    const Engine& chosen = engine_named(engine);
    const Engine* const used[] = {&chosen};
    return {{&chosen, settings_for(chosen, Scene{}, parse_changes(settings, used))}, 1.0 / 60, true, {}};
}

class EveryCase : public ::testing::TestWithParam<const Case*> {};

std::string name_of_test(const ::testing::TestParamInfo<const Case*>& test) {
    std::string name(test.param->name);
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(HardCases, EveryCase, ::testing::ValuesIn(find_cases({})), name_of_test);

constexpr int pile = 24, crushed_ball = 25, heavy_on_light = 33;

void expect_pass(const CaseResult& result) {
    EXPECT_EQ(name_of(result.verdict), "pass") << result.reason;
    for (const CaseRow& row : result.rows)
        EXPECT_TRUE(row.verdict == Verdict::pass || !row.tolerance)
            << row.quantity << ": expected " << row.expected.value_or(0) << ", measured " << row.measured
            << ", error " << row.error << ", tolerance " << row.tolerance.value_or(0);
}

TEST_P(EveryCase, passesOnTheContinuousSolver) {
    const CaseResult result = run_case(*GetParam(), contender("custom", {"solver=continuous"}));
    expect_pass(result);
    // Balls that are pressed together cannot be put in order of time.
    const int number = GetParam()->number;
    if (number != pile && number != crushed_ball && number != heavy_on_light) {
        EXPECT_EQ(result.handed_over, 0U);
    }
}

TEST_P(EveryCase, passesAtAnotherStep) {
    CaseInput input = contender("custom", {"solver=continuous"});
    input.dt = 1.0 / 30;
    expect_pass(run_case(*GetParam(), input));
}

/// Gases on the reference run through the same code for a minute under the sanitizers.
bool is_long_gas(const Case& one) {
    constexpr std::string_view gases[] = {"disc-gas", "impact-statistics", "equipartition"};
    return test::in_small && std::ranges::find(gases, one.name) != std::end(gases);
}

// A falling heap has resting contacts between balls, so it is not among what the reference is asked for here.
class EveryCaseWithAnOrder : public ::testing::TestWithParam<const Case*> {};

INSTANTIATE_TEST_SUITE_P(HardCases, EveryCaseWithAnOrder, ::testing::ValuesIn([] {
                             auto all = find_cases({});
                             std::erase_if(all, [](const Case* one) {
                                 return one->number == pile || is_long_gas(*one);
                             });
                             return all;
                         }()),
                         name_of_test);

TEST_P(EveryCaseWithAnOrder, passesOnTheReference) {
    constexpr int deep_overlap = 21;
    const CaseResult result = run_case(*GetParam(), contender("reference"));
    const int number = GetParam()->number;
    // What it cannot do exactly it refuses, and says why.
    if (result.verdict == Verdict::refused && (number == deep_overlap || number == crushed_ball)) {
        EXPECT_NE(result.reason.find("reference: "), std::string::npos) << result.reason;
        for (const CaseRow& row : result.rows) EXPECT_NE(row.verdict, Verdict::fail) << row.quantity;
        return;
    }
    expect_pass(result);
}

/// In full: the pace of events there is above what moving parts may cause.
TEST(Cases, allCollisionsThatSpellPiAreCounted) {
    CaseInput input = contender("custom", {"solver=continuous"});
    input.quick = false;
    const std::vector<std::string> names{"galperin"};
    expect_pass(run_case(*find_cases(names).front(), input));
}

/// Whole tables: every row that is no mere note says what was expected and how far off it is, and what must
/// hold on any engine holds.
void expect_whole(const CaseResult& result) {
    EXPECT_NE(name_of(result.verdict), "refused") << result.reason;
    EXPECT_NE(name_of(result.verdict), "fail") << result.reason;
    EXPECT_FALSE(result.rows.empty());
    for (const CaseRow& row : result.rows) {
        EXPECT_FALSE(row.quantity.empty());
        EXPECT_NE(name_of(row.verdict), "fail") << row.quantity << ": measured " << row.measured;
        if (row.expected && !std::isnan(row.measured)) {
            EXPECT_DOUBLE_EQ(row.error, std::abs(row.measured - *row.expected)) << row.quantity;
        }
    }
    EXPECT_GT(result.steps, 0U);
}

/// Cases whose walls, or balls, the simple solver tunnels through.
constexpr std::string_view tunnels[] = {"thin-wall", "opposed-balls", "crushed-ball", "equipartition"};

TEST_P(EveryCase, isMeasuredOnTheSimpleSolver) {
    const CaseResult result = run_case(*GetParam(), contender("custom", {"solver=simple"}));
    if (std::ranges::find(tunnels, GetParam()->name) != std::end(tunnels))
        EXPECT_EQ(name_of(result.verdict), "fail");
    else
        expect_whole(result);
}

TEST_P(EveryCase, isMeasuredOnBox2d) {
    expect_whole(run_case(*GetParam(), contender("box2d")));
}

/// The error of the rows whose quantity begins so; infinite where one was not reached or none is there.
double worst_error(const CaseResult& result, std::string_view quantity) {
    double worst = -1;
    for (const CaseRow& row : result.rows) {
        if (!row.quantity.starts_with(quantity)) continue;
        if (std::isnan(row.error)) return INFINITY;
        worst = std::max(worst, row.error);
    }
    return worst < 0 ? INFINITY : worst;
}

struct Bound {
    const char *name, *quantity;
    double error;
};

void expect_within(const CaseInput& input, std::span<const Bound> bounds) {
    for (const Bound& bound : bounds) {
        const std::vector<std::string> names{bound.name};
        const CaseResult result = run_case(*find_cases(names).front(), input);
        EXPECT_LE(worst_error(result, bound.quantity), bound.error) << bound.name << ": " << bound.quantity;
    }
}

// What a single impact does it gets right, a motion iteration late; what is fast goes through.
TEST(Cases, simpleSolverStaysWithinItsBounds) {
    const CaseInput input = contender("custom", {"solver=simple"});
    const Bound bounds[] = {{"zeno-drop", "speeds", 1e-8},
                            {"zeno-drop", "time of the last impact", 0.5},
                            {"elastic-drop", "energy drift, relative", 1e-9},
                            {"head-on", "", 1e-14},
                            {"friction-bounce", "", 1e-12},
                            {"deep-overlap", "energy gained", 1e-12}};
    expect_within(input, bounds);
}

// Single precision; times are those of steps of 1/60 s; flight is off by ½·g·h·t.
TEST(Cases, box2dStaysWithinItsBounds) {
    const Bound bounds[] = {{"galperin", "collisions, M/m = 100^0", 0},
                            {"galperin", "collisions, M/m = 100^1", 0},
                            {"head-on", "first ball after", 1e-6},
                            {"head-on", "momentum", 1e-6},
                            {"incline", "way down in 1 s, smooth", 9.81 / 2 / 60},
                            {"flipper", "time", 1.0 / 60},
                            {"friction-bounce", "", 1e-5},
                            {"collinear-segments", "speed along", 1e-3},
                            {"pile", "deepest overlap", 0.05}};
    expect_within(contender("box2d"), bounds);
}

// A case whose rows nobody is held to could not fail.
TEST(Cases, mustJudgeAtLeastOneQuantity) {
    const Case notes{99, "notes", "Notes",
                     "", "",      [](Experiment& experiment) { experiment.note("n", "", 1); }};
    EXPECT_THROW(static_cast<void>(run_case(notes, contender("reference"))), std::logic_error);
}

// However well the mean fits, a statistic that is noisier than its row allows is no answer.
TEST(Cases, aStatisticMustBeAsCertainAsItsRowDemands) {
    const auto verdict_of = [](const Case& one) {
        return name_of(run_case(one, contender("reference")).verdict);
    };
    EXPECT_EQ(verdict_of({99, "narrow", "Narrow", "", "",
                          [](Experiment& it) {
                              it.statistic("mean", "", 1, Estimate{1.01, 0.02}, 0.01, 0.02);
                          }}),
              "pass");
    EXPECT_EQ(verdict_of({99, "wide", "Wide", "", "",
                          [](Experiment& it) {
                              it.statistic("mean", "", 1, Estimate{1, 0.03}, 0.01, 0.02);
                          }}),
              "fail");
    EXPECT_EQ(verdict_of({99, "off", "Off", "", "",
                          [](Experiment& it) {
                              it.statistic("mean", "", 1, Estimate{1.04, 0.01}, 0.01, 0.02);
                          }}),
              "fail");
}

// Its pressure is that of balls in motion: none may fall asleep, unless told so.
TEST(Cases, theGasIsRunAwakeUnlessToldOtherwise) {
    const std::vector<std::string> names{"disc-gas"};
    const Case& gas = *find_cases(names).front();
    const CaseRun run = run_recommended(gas, contender("custom"), {});
    expect_pass(run.result);
    EXPECT_EQ(run.result.handed_over, 0U);
    const auto sleep = std::ranges::find(run.recommended, "sleep", &SettingChange::name);
    ASSERT_NE(sleep, run.recommended.end());
    EXPECT_EQ(sleep->value, "off");

    const Engine* const used[] = {&engine_named("custom")};
    const auto changes = parse_changes(std::vector<std::string>{"sleep=on"}, used);
    const CaseRun told = run_recommended(gas, contender("custom", {"sleep=on"}), changes);
    EXPECT_TRUE(std::ranges::find(told.recommended, "sleep", &SettingChange::name) == told.recommended.end());
}

TEST(Cases, areFoundByNameAndNumber) {
    const std::vector<std::string> names{"galperin", "1"};
    const auto found = find_cases(names);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0]->name, "zeno-drop");
    EXPECT_EQ(found[1]->number, 5);
    const std::vector<std::string> unknown{"perpetuum-mobile"};
    try {
        static_cast<void>(find_cases(unknown));
        FAIL() << "an unknown case was found";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("galperin"), std::string::npos);
    }
}

TEST(Cases, jsonHasEveryRow) {
    const CaseInput input = contender("box2d");
    const std::vector<std::string> names{"zeno-drop"};
    const Case& zeno = *find_cases(names).front();
    const CaseRun runs[] = {{&zeno, run_case(zeno, input)}};
    const auto json = nlohmann::json::parse(to_json(runs, input));
    EXPECT_EQ(json["format"], "flipside-cases/1");
    EXPECT_EQ(json["engine"], "box2d");
    EXPECT_EQ(json["settings"]["substeps"], "1");
    EXPECT_EQ(json["verdicts"]["measured"], 1);
    ASSERT_EQ(json["cases"].size(), 1U);
    EXPECT_EQ(json["cases"][0]["rows"].size(), runs[0].result.rows.size());
    EXPECT_NEAR(json["cases"][0]["rows"][2]["expected"].get<double>(), 1.354571, 1e-6);
}

}  // namespace
}  // namespace flipside::lab
