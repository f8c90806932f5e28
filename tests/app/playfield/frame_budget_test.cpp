#include "app/window/playfield/frame_budget.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

/// Seconds until the artwork is left out, or comes back.
int seconds_until(FrameBudget& budget, bool affords, double rate, double physics) {
    int seconds = 0;
    while (budget.affords_artwork() != affords && seconds < 10000) {
        budget.observe(1, rate, physics);
        ++seconds;
    }
    return seconds;
}

TEST(FrameBudget, LeavesTheArtworkOutWhereFramesComeTooSeldom) {
    FrameBudget budget;
    EXPECT_TRUE(budget.affords_artwork());
    EXPECT_EQ(seconds_until(budget, false, 30, 0.1), FrameBudget::patience);
}

TEST(FrameBudget, OneBadSecondIsNothing) {
    FrameBudget budget;
    for (int i = 0; i < 100; ++i) budget.observe(1, i % 3 == 0 ? 60 : 30, 0.1);
    EXPECT_TRUE(budget.affords_artwork());
}

TEST(FrameBudget, EnginesThatTakeTheTimeCostNoArtwork) {
    FrameBudget budget;
    for (int i = 0; i < 100; ++i) budget.observe(1, 20, 0.8);
    EXPECT_TRUE(budget.affords_artwork());
}

TEST(FrameBudget, ItIsTriedAgainAfterAWhileAndThenAfterTwiceThat) {
    FrameBudget budget;
    for (double pause = FrameBudget::first_pause; pause < 200; pause *= 2) {
        seconds_until(budget, false, 30, 0.1);
        EXPECT_EQ(seconds_until(budget, true, 60, 0.1), pause);
    }
}

}  // namespace
}  // namespace flipside::app
