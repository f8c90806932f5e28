// The gate's end and the smooth joint in every orientation that their cases have, on both engines that order
// events by time, at several steps.

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/cases/case.hpp"
#include "lab/contenders/engines.hpp"

namespace flipside::lab {
namespace {

void expect_pass_everywhere(const std::string& name, std::string_view engine,
                            const std::vector<std::string>& settings, double dt) {
    const Engine& chosen = engine_named(engine);
    const Engine* const used[] = {&chosen};
    const CaseInput input{{&chosen, settings_for(chosen, Scene{}, parse_changes(settings, used))},
                          dt,
                          flipside::test::in_small,
                          {}};
    const std::vector<std::string> names{name};
    const CaseResult result = run_case(*find_cases(names).front(), input);
    EXPECT_EQ(name_of(result.verdict), "pass") << engine << ", step " << dt << ": " << result.reason;
    EXPECT_EQ(result.handed_over, 0U);
    for (const CaseRow& row : result.rows)
        EXPECT_TRUE(row.verdict == Verdict::pass)
            << engine << ", step " << dt << ": " << row.quantity << ": measured " << row.measured;
}

TEST(EveryOrientation, GateEnd) {
    expect_pass_everywhere("gate-end", "custom", {"solver=continuous"}, 1.0 / 60);
    expect_pass_everywhere("gate-end", "reference", {}, 1.0 / 60);
}

TEST(EveryOrientation, SmoothJoint) {
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 97, 1.0 / 240, 1.0 / 1000}) {
        if (flipside::test::in_small && dt < 1.0 / 240) continue;  // more steps than a quick case may take
        expect_pass_everywhere("smooth-joint", "custom", {"solver=continuous"}, dt);
    }
    for (const double dt : {1.0 / 30, 1.0 / 240}) expect_pass_everywhere("smooth-joint", "reference", {}, dt);
}

}  // namespace
}  // namespace flipside::lab
