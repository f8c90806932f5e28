#include "app/window/accumulator.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

TEST(Accumulator, MakesAStepOfEverySixtiethOfASecondWhateverTheFrameRate) {
    for (const double frames : {7.0, 24.0, 60.0, 144.0, 1000.0}) {
        Accumulator accumulator(1.0 / 60, 0.2);
        long steps = 0;
        for (int i = 0; i < 10 * frames; ++i) steps += accumulator.advance(1 / frames);
        EXPECT_NEAR(static_cast<double>(steps), 600, 1) << frames << " frames per second";
    }
}

TEST(Accumulator, SlowMotionMakesProportionallyFewerSteps) {
    Accumulator accumulator(1.0 / 60, 0.2);
    int steps = 0;
    for (int i = 0; i < 600; ++i) steps += accumulator.advance(0.1 / 60);
    EXPECT_NEAR(steps, 60, 1);
}

TEST(Accumulator, DropsWhatASlowMachineCannotCatchUp) {
    Accumulator accumulator(0.01, 0.1);
    EXPECT_EQ(accumulator.advance(60), 10);
    EXPECT_NEAR(accumulator.waiting(), 0, 1e-12);
    EXPECT_EQ(accumulator.advance(0.01), 1);
}

TEST(Accumulator, AStepLongerThanTheLimitIsStillMade) {
    Accumulator accumulator(0.5, 0.1);
    EXPECT_EQ(accumulator.advance(0.3), 0);
    EXPECT_EQ(accumulator.advance(0.3), 1);
}

TEST(Accumulator, ExactFramesGiveExactSteps) {
    Accumulator accumulator(1.0 / 60, 0.1);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(accumulator.advance(1.0 / 60), 1) << i;
}

TEST(Accumulator, TimeDoesNotRunBackwards) {
    Accumulator accumulator(0.01, 0.1);
    EXPECT_EQ(accumulator.advance(-5), 0);
    EXPECT_EQ(accumulator.waiting(), 0);
}

}  // namespace
}  // namespace flipside::app
