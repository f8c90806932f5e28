#include "lab/statistics/median.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "lab/scenes/dice.hpp"

namespace flipside::lab {
namespace {

std::vector<double> numbers_to(int n) {
    std::vector<double> values;
    for (int i = n; i >= 1; --i) values.push_back(i);
    return values;
}

TEST(Median, IntervalsAreThoseOfTheTables) {
    // Ranks of the 95 % interval of a median: Conover, Practical Nonparametric Statistics, by the binomial.
    for (const auto& [n, low, high] : {std::tuple{10, 2, 9}, {20, 6, 15}, {25, 8, 18}, {50, 18, 33}}) {
        const Median median = median_of(numbers_to(n));
        EXPECT_EQ(median.value, 0.5 * (n + 1));
        EXPECT_EQ(median.low, low) << n;
        EXPECT_EQ(median.high, high) << n;
    }
}

TEST(Median, OfFewValuesTheIntervalIsTheirRange) {
    EXPECT_EQ(median_of({7}).value, 7);
    EXPECT_EQ(median_of({7}).low, 7);
    EXPECT_EQ(median_of({7, 3}).value, 5);
    EXPECT_EQ(median_of({7, 3, 1, 9, 5}).low, 1);
    EXPECT_EQ(median_of({7, 3, 1, 9, 5}).high, 9);
}

TEST(Median, IntervalsHoldTheTrueMedianAsOftenAsTheySay) {
    Dice dice(7);
    int within = 0;
    constexpr int rounds = 4000;
    for (int i = 0; i < rounds; ++i) {
        std::vector<double> values;
        for (int k = 0; k < 25; ++k) values.push_back(dice.below(1));
        const Median median = median_of(values);
        within += median.low <= 0.5 && 0.5 <= median.high;
    }
    // 95.7 % by the binomial; three standard deviations are 1 %.
    EXPECT_GT(within, 0.947 * rounds);
    EXPECT_LT(within, 0.967 * rounds);
}

}  // namespace
}  // namespace flipside::lab
