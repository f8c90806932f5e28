#include "app/window/traces.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

Event impact(BallNumber ball, PartIndex part, double time) {
    Event event;
    event.time = time;
    event.ball = ball;
    event.other = Other::part(part);
    event.speed = 1;
    return event;
}

Ball ball_at(BallNumber number, Vec2 position) {
    Ball ball;
    ball.number = number;
    ball.position = position;
    return ball;
}

TEST(Traces, AHitLightsThePartForATenthOfASecond) {
    Traces traces(3);
    const Event event = impact(0, 1, 2.0);
    traces.observe({&event, 1}, {}, 2.0);
    EXPECT_DOUBLE_EQ(traces.light(1, 2.0), 1);
    EXPECT_NEAR(traces.light(1, 2.05), 0.5, 1e-9);
    EXPECT_EQ(traces.light(1, 2.1), 0);
    EXPECT_EQ(traces.light(0, 2.0), 0);
}

TEST(Traces, HitsAreForgottenAfterHalfASecond) {
    Traces traces(1);
    const Event event = impact(7, 0, 1.0);
    traces.observe({&event, 1}, {}, 1.0);
    traces.observe({}, {}, 1.4);
    EXPECT_EQ(traces.hits().size(), 1U);
    traces.observe({}, {}, 1.6);
    EXPECT_TRUE(traces.hits().empty());
}

TEST(Traces, ATrackIsOneSecondLongAndGoesWithItsBall) {
    Traces traces(0);
    for (int i = 0; i < 300; ++i) {
        const Ball ball = ball_at(4, {0.01 * i, 0});
        traces.observe({}, {&ball, 1}, i / 60.0);
    }
    ASSERT_TRUE(traces.tracks().contains(4));
    EXPECT_NEAR(static_cast<double>(traces.tracks().at(4).size()), 60, 2);
    EXPECT_DOUBLE_EQ(traces.tracks().at(4).back().x, 2.99);
    traces.observe({}, {}, 6);
    EXPECT_TRUE(traces.tracks().empty());
}

}  // namespace
}  // namespace flipside::app
