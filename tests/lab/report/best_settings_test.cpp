#include "lab/report/best_settings.hpp"

#include <gtest/gtest.h>

#include "lab/report/advice.hpp"

namespace flipside::lab::report {
namespace {

/// Six windows, of which each costs a little more than the one before.
sweep::Figures figures(const std::string& contender, const std::string& engine, double dt, double error,
                       double cost) {
    sweep::Figures f;
    f.variant = "toy", f.contender = contender, f.engine = engine, f.dt = dt;
    f.median = error, f.median_low = 0.9 * error, f.median_high = 1.1 * error;
    f.cpu_min = cost;
    for (std::size_t window = 0; window < 6; ++window)
        f.costs[window] = cost * (1 + 0.01 * static_cast<double>(window));
    return f;
}

TEST(BestSettings, AreTheCheapestThatAreSurelyGoodEnough) {
    const std::vector<sweep::Figures> all{
        figures("box2d", "box2d", 1. / 60, 0.095, 1e-4),  // its interval reaches beyond a tenth
        figures("box2d", "box2d", 1. / 120, 0.05, 4e-3),
        figures("box2d", "box2d", 1. / 240, 0.01, 5e-3),
        figures("custom-continuous", "custom", 1. / 30, 1e-14, 9e-4),  // longer than a frame
        figures("custom-continuous", "custom", 1. / 60, 1e-14, 1e-3),
        figures("custom-continuous", "custom", 1. / 240, 1e-14, 0.95e-3),  // hardly cheaper
        figures("reference-53", "reference", 1. / 60, 1e-15, 1e-5)};
    const auto best = best_settings(all);
    ASSERT_EQ(best.size(), 1U);
    EXPECT_EQ(best[0].take, &all[4]);
    EXPECT_EQ(best[0].instead, &all[1]);
    ASSERT_TRUE(best[0].ratio.has_value());
    EXPECT_NEAR(best[0].ratio->value, 4, 1e-9);
    EXPECT_EQ(best[0].yardstick, &all[6]);
    EXPECT_TRUE(ignores_step(all, all[4]));
    EXPECT_FALSE(ignores_step(all, all[1]));
    EXPECT_TRUE(is_telling(all[0], best));

    const Pick pick = pick_of(all, best[0]);
    EXPECT_EQ(pick.take, "custom-continuous at 1/60 s or any other step");
    EXPECT_EQ(pick.error, "exact: 1e-14 (9e-15 to 1.1e-14)");
    EXPECT_EQ(pick.cost, "1 ms");
    EXPECT_EQ(pick.instead, "box2d at 1/120 s: 0.05 radii, 4 times (4 to 4) the cost");
}

TEST(BestSettings, AnotherEngineIsTakenWhereItIsCheaper) {
    const std::vector<sweep::Figures> all{figures("box2d", "box2d", 1. / 60, 0.05, 1e-4),
                                          figures("custom-continuous", "custom", 1. / 60, 1e-14, 1e-3)};
    const auto best = best_settings(all);
    EXPECT_EQ(best[0].take, &all[0]);
    EXPECT_EQ(best[0].instead, &all[1]);
    EXPECT_NE(findings_of(all, best)[0].find("box2d in 1 of 1 kinds of scene"), std::string::npos);
}

TEST(BestSettings, MayBeNothingAtAll) {
    const std::vector<sweep::Figures> all{figures("box2d", "box2d", 1. / 60, 3, 1e-4)};
    const auto best = best_settings(all);
    EXPECT_EQ(best[0].take, nullptr);
    EXPECT_EQ(pick_of(all, best[0]).take, "nothing");
}

}  // namespace
}  // namespace flipside::lab::report
