#include "lab/comparison/parting.hpp"

#include <gtest/gtest.h>

#include "lab/comparison/impact.hpp"

namespace flipside::lab {
namespace {

constexpr double step = 0.1, end = 10;

TEST(MatchImpacts, EqualRunsNeverPart) {
    const std::vector run{impact(1, 0, 3), impact(1.5, 1, 3), impact(2, 0, 4)};
    const ImpactMatch match = match_impacts(run, run, step, end);
    EXPECT_FALSE(match.parting);
    EXPECT_EQ(match.total, 3U);
    EXPECT_EQ(match.before_parting, 3U);
    EXPECT_EQ(match.matched.at(0), 2U);
    EXPECT_EQ(match.matched.at(1), 1U);
}

TEST(MatchImpacts, FindsTheEarliestDifferenceOfAnyBall) {
    const std::vector first{impact(1, 0, 3), impact(1.5, 1, 3), impact(2, 0, 4), impact(4, 1, 5)};
    const std::vector second{impact(1.09, 0, 3), impact(1.5, 1, 3), impact(3, 1, 6), impact(5, 0, 7)};
    const ImpactMatch match = match_impacts(first, second, step, end);
    ASSERT_TRUE(match.parting);
    EXPECT_EQ(match.parting->ball, 0U);  // part 4 at 2 s against part 7 at 5 s; ball 1 parts at 3 s
    EXPECT_EQ(match.parting->index, 1U);
    EXPECT_EQ(match.parting->time, 2);
    EXPECT_EQ(match.parting->first->other, Other::part(4));
    EXPECT_EQ(match.parting->second->other, Other::part(7));
    EXPECT_EQ(match.total, 2U);
    EXPECT_EQ(match.before_parting, 2U);
}

TEST(MatchImpacts, ALateImpactPartsThoughThePartIsTheSame) {
    const ImpactMatch match =
        match_impacts(std::vector{impact(1, 0, 3)}, std::vector{impact(1.11, 0, 3)}, step, end);
    ASSERT_TRUE(match.parting);
    EXPECT_EQ(match.total, 0U);
    EXPECT_EQ(match.in_order, 1U);
}

TEST(MatchImpacts, AMissingImpactPartsUnlessTheEndIsNear) {
    const ImpactMatch missing = match_impacts({}, std::vector{impact(9.8, 2, 3)}, step, end);
    ASSERT_TRUE(missing.parting);
    EXPECT_FALSE(missing.parting->first);
    EXPECT_EQ(missing.parting->time, 9.8);
    EXPECT_FALSE(match_impacts({}, std::vector{impact(9.95, 2, 3)}, step, end).parting);
}

TEST(Spread, IsTheGreatestDistanceInRadiiOfBallsThatBothHave) {
    std::vector<Ball> first(3), second(3);
    for (BallNumber i = 0; i < 3; ++i) {
        first[i].number = second[i].number = i;
        first[i].radius = second[i].radius = i + 1;
    }
    second[0].position = {3, 0};
    second[2].position = {0, 12};
    EXPECT_EQ(spread(first, second).radii, 4);
    EXPECT_EQ(spread(first, second).ball, 2U);
    EXPECT_TRUE(spread(first, second).same_balls);
    EXPECT_EQ(spread(first, second).common, 3U);
    second.pop_back();
    EXPECT_EQ(spread(first, second).radii, 3);
    EXPECT_EQ(spread(first, second).common, 2U);
    EXPECT_FALSE(spread(first, second).same_balls);
    EXPECT_FALSE(spread(second, first).same_balls);
    second[1].number = 2;  // balls 0 and 2 left
    EXPECT_FALSE(spread(first, second).same_balls);
}

}  // namespace
}  // namespace flipside::lab
