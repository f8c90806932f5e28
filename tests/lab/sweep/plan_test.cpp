#include <set>

#include <gtest/gtest.h>

#include "lab/sweep/sweep.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::sweep {
namespace {

TEST(SweepPlan, AFullOneHasFiveHundredWindowsOfEachVariant) {
    const Plan plan{.variants = standard_variants()};
    EXPECT_GE(plan.windows(), 500U);
    EXPECT_GE(plan.repetitions, 5U);
    ASSERT_EQ(plan.variants.size(), 4U);
    EXPECT_EQ(load(plan.variants[3])->balls.size(), 320U);
    std::set<std::pair<std::string, std::uint32_t>> units;
    for (const Unit& unit : units_of(plan)) units.insert({unit.variant->name, unit.block});
    EXPECT_EQ(units.size(), 4U * plan.blocks);
}

TEST(SweepPlan, EveryStepDividesTheUnitOfWindows) {
    for (const bool quick : {false, true})
        for (const Contender& contender : contenders()) {
            const auto steps = steps_of(contender, quick ? quick_plan({}, 1) : Plan{});
            ASSERT_FALSE(steps.empty()) << contender.name;
            for (const double dt : steps) {
                const double parts = window_unit / dt;
                EXPECT_NEAR(parts, std::round(parts), 1e-9) << contender.name;
            }
        }
}

TEST(SweepPlan, ContendersHaveNamesOfTheirOwnAndSettingsThatTheirEnginesKnow) {
    const auto scene = load(standard_variants().front());
    std::set<std::string_view> names;
    for (const Contender& contender : contenders()) {
        names.insert(contender.name);
        EXPECT_EQ(settings_of(contender, *scene).specs().data(),
                  engine_named(contender.engine).settings.data());
    }
    EXPECT_EQ(names.size(), contenders().size());
    EXPECT_EQ(settings_of(contender_named("box2d-20-10"), *scene).integer("velocity_iterations"), 20);
    EXPECT_THROW(static_cast<void>(contender_named("box3d")), InputError);
}

const Contender& defined(const std::string& text) {
    return add_contender(parse_contenders({&text, 1}).front());
}

TEST(SweepPlan, AContenderOfOnesOwnIsSweptAtItsStepOrAtAll) {
    const Contender& one = defined("mine=box2d,dt=1/240,bullets=off,substeps=2");
    EXPECT_EQ(steps_of(one, Plan{}), std::vector<double>{1.0 / 240});
    const auto scene = load(standard_variants().front());
    EXPECT_EQ(settings_of(one, *scene).text("bullets"), "off");
    EXPECT_EQ(settings_of(one, *scene).integer("substeps"), 2);
    EXPECT_EQ(&contender_named("mine"), &one);
    EXPECT_EQ(&defined("mine=box2d,dt=1/240,bullets=off,substeps=2"), &one);
    EXPECT_EQ(steps_of(defined("at-all=custom"), Plan{}).size(), 9U);
}

TEST(SweepPlan, AContenderOfOnesOwnComesBackFromThePlan) {
    Plan plan{.variants = standard_variants()};
    plan.contenders = {&contender_named("box2d"), &defined("kept=box2d,dt=1/120,chord_error=1e-6")};
    EXPECT_EQ(parse_plan(to_json(plan), "plan.json").contenders, plan.contenders);
    std::string text = to_json(plan);
    const auto swapped = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        return other.replace(other.find(from), from.size(), to);
    };
    const auto read = parse_plan(swapped("\"kept\"", "\"unheard-of\""), "plan.json");
    EXPECT_EQ(read.contenders[1]->name, "unheard-of");
    EXPECT_EQ(read.contenders[1]->settings, "chord_error=1e-6");
    for (const auto& [from, to] : {std::pair("chord_error=1e-6", "chord_error=-1"),
                                   {"chord_error=1e-6", "chord=1e-6"},
                                   {"chord_error=1e-6", ""},
                                   {": 120", ": 130"}})
        EXPECT_THROW(static_cast<void>(parse_plan(swapped(from, to), "plan.json")), InputError) << to;
}

TEST(SweepPlan, ANameHasOneMeaningAndWindowsHaveWholeSteps) {
    EXPECT_THROW(defined("box2d=box2d,substeps=4"), InputError);
    static_cast<void>(defined("taken=box2d,substeps=4"));
    EXPECT_THROW(defined("taken=box2d,substeps=5"), InputError);
    for (const char* step : {"1/37", "0.05", "1/15", "1/15360"})
        EXPECT_THROW(defined(std::string("odd=custom,dt=") + step), InputError) << step;
}

TEST(SweepPlan, ThinsWhereManyBallsTakeManySteps) {
    const Plan plan{.most_work = 8'000};
    EXPECT_EQ(thinning(plan, 1, 0.5, 1.0 / 7680), 1U);
    EXPECT_EQ(thinning(plan, 320, 0.1, 1.0 / 240), 1U);
    EXPECT_EQ(thinning(plan, 320, 0.1, 1.0 / 480), 2U);
    EXPECT_EQ(thinning(plan, 320, 0.1, 1.0 / 7680), 32U);
    const Plan whole{.most_work = unlimited_work};
    EXPECT_EQ(thinning(whole, 100'000, 0.5, 1.0 / 7680), 1U);
}

TEST(SweepVariants, ByScenesAndBalls) {
    EXPECT_EQ(variants_of({}, 0), standard_variants());
    EXPECT_EQ(variants_of({"pinball"}, 0).size(), 2U);
    const auto three = variants_of({"pinball", "toy"}, 3);
    ASSERT_EQ(three.size(), 2U);
    EXPECT_EQ(three[0].name, "pinball-3");
    EXPECT_EQ(three[1].balls, 3);
    EXPECT_EQ(load(variants_of({"rain"}, 40).front())->balls.size(), 40U);
    EXPECT_THROW(static_cast<void>(variants_of({"cradle"}, 3)), InputError);
    EXPECT_THROW(static_cast<void>(variants_of({"none"}, 0)), InputError);
}

TEST(SweepVariants, TrajectoriesDifferByTheDiceAlone) {
    const Variant variant = variants_of({"pinball"}, 8).front();
    const auto scene = load(variant);
    const auto strengths = [&](std::uint64_t seed) {
        Dice dice(seed);
        std::vector<double> all;
        for (const TimedControl& timed : trajectory_script(variant, *scene, dice))
            if (const auto* launch = std::get_if<control::Launch>(&timed.control))
                all.push_back(launch->strength);
        return all;
    };
    EXPECT_EQ(strengths(1).size(), 1U);
    EXPECT_EQ(strengths(1), strengths(1));
    EXPECT_NE(strengths(1), strengths(2));
}

}  // namespace
}  // namespace flipside::lab::sweep
