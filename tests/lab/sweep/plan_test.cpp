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

TEST(SweepPlan, ThinsWhereManyBallsTakeManySteps) {
    const Plan plan{.most_work = 8'000};
    EXPECT_EQ(thinning(plan, 1, 0.5, 1.0 / 7680), 1U);
    EXPECT_EQ(thinning(plan, 320, 0.1, 1.0 / 240), 1U);
    EXPECT_EQ(thinning(plan, 320, 0.1, 1.0 / 480), 2U);
    EXPECT_EQ(thinning(plan, 320, 0.1, 1.0 / 7680), 32U);
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
