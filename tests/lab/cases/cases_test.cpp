// The hard cases: event-ordered solvers pass all of them; time-stepping ones give whole tables.

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lab/cases/case.hpp"
#include "lab/engines.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {
namespace {

CaseInput entrant(std::string_view engine, const std::vector<std::string>& settings = {}) {
    const Engine& chosen = engine_named(engine);
    const Engine* const used[] = {&chosen};
    return {{&chosen, settings_for(chosen, Scene{}, parse_changes(settings, used))}, 1.0 / 60, true, {}};
}

class EveryCase : public ::testing::TestWithParam<const Case*> {};

INSTANTIATE_TEST_SUITE_P(HardCases, EveryCase, ::testing::ValuesIn(find_cases({})), [](const auto& test) {
    std::string name(test.param->name);
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST_P(EveryCase, passesOnTheContinuousSolver) {
    const CaseResult result = run_case(*GetParam(), entrant("custom", {"solver=continuous"}));
    EXPECT_EQ(name_of(result.verdict), "pass") << result.reason;
    EXPECT_EQ(result.handed_over, 0U);
    for (const CaseRow& row : result.rows)
        EXPECT_TRUE(row.verdict == Verdict::pass || !row.tolerance)
            << row.quantity << ": expected " << row.expected.value_or(0) << ", measured " << row.measured
            << ", error " << row.error << ", tolerance " << row.tolerance.value_or(0);
}

/// Whole tables: every row that is no mere note says what was expected and how far off it is.
void expect_whole(const CaseResult& result) {
    EXPECT_NE(name_of(result.verdict), "refused") << result.reason;
    EXPECT_FALSE(result.rows.empty());
    for (const CaseRow& row : result.rows) {
        EXPECT_FALSE(row.quantity.empty());
        if (row.expected && !std::isnan(row.measured)) {
            EXPECT_DOUBLE_EQ(row.error, std::abs(row.measured - *row.expected)) << row.quantity;
        }
    }
    EXPECT_GT(result.steps, 0U);
}

TEST_P(EveryCase, isMeasuredOnTheDiscreteSolver) {
    expect_whole(run_case(*GetParam(), entrant("custom", {"solver=discrete"})));
}

TEST_P(EveryCase, isMeasuredOnBox2d) {
    expect_whole(run_case(*GetParam(), entrant("box2d")));
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
    const CaseInput input = entrant("box2d");
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
