// The toy's experiment holds what the toy's documentation says of its quadtree.

#include "lab/pairs/pair_tests.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace flipside::lab {
namespace {

TEST(PairTests, FitOfALine) {
    const LinearFit exact = fit_line({1, 2, 4}, {5, 7, 11});
    EXPECT_DOUBLE_EQ(exact.slope, 2);
    EXPECT_DOUBLE_EQ(exact.intercept, 3);
    EXPECT_DOUBLE_EQ(exact.r_squared, 1);
    // By hand: means 2 and 2, Sxx = 2, Sxy = 1, Syy = 6.
    const LinearFit rough = fit_line({1, 2, 3}, {1, 4, 1 + 1});
    EXPECT_NEAR(rough.slope, 0.5, 1e-12);
    EXPECT_NEAR(rough.r_squared, 0.25 / (14.0 / 3) * 2, 1e-12);
}

TEST(PairTests, CrossingWithBruteForce) {
    // 2n meets n(n−1)/2 = 1, 3, 6, 10, 15, 21 at 5.
    EXPECT_DOUBLE_EQ(crossing_with_brute_force(2, {4, 6, 8, 10, 12, 14}).value(), 5);
    EXPECT_DOUBLE_EQ(crossing_with_brute_force(2, {2, 2.5}).value(), 2 + 1 / 1.5);
    EXPECT_DOUBLE_EQ(crossing_with_brute_force(2, {0.5, 2.5}).value(), 2);
    EXPECT_FALSE(crossing_with_brute_force(2, {1, 3, 6}));
}

TEST(PairTests, TheToysExperiment) {
    const PairTests found = count_pair_tests(10, 1000);
    ASSERT_EQ(found.rows.size(), 5U);
    const PairTests::Row &brute = found.rows[0], &quadtree = found.rows[1], &grid = found.rows[3];
    ASSERT_EQ(quadtree.broad_phase, "quadtree");
    ASSERT_EQ(grid.broad_phase, "grid");
    for (std::size_t i = 0; i < brute.tests.size(); ++i)
        EXPECT_EQ(brute.tests[i], static_cast<double>((i + 2) * (i + 1)) / 2);
    EXPECT_LE(quadtree.tests.back(), 92);
    EXPECT_LT(quadtree.line.slope, 3);
    EXPECT_GE(quadtree.line.r_squared, 0.99);
    EXPECT_LE(quadtree.crossing.value(), 6);
    EXPECT_LT(grid.tests.back(), 1.1 * quadtree.tests.back());

    ASSERT_EQ(found.growth.back().balls, 1000U);
    EXPECT_EQ(found.growth.back().costs[0].tests_per_ball, 999 / 2.0);
    // At one density the grid's tests per ball stay what they are.
    EXPECT_LT(found.growth.back().costs[3].tests_per_ball,
              1.2 * found.growth.front().costs[3].tests_per_ball);
    const auto json = nlohmann::json::parse(to_json(found));
    EXPECT_EQ(json["toy"][1]["tests"].size(), 31U);
    EXPECT_EQ(json["toy"][0]["crossing"], nullptr);
    EXPECT_EQ(json["growth"].size(), found.growth.size());
}

}  // namespace
}  // namespace flipside::lab
