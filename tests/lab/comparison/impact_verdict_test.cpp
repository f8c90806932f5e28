#include "lab/comparison/impact_verdict.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "lab/comparison/impact.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/session/session.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {
namespace {

constexpr Other first_ball = Other::ball(0);
constexpr double apart = 0.1;  ///< s at most, of one impact in two runs

ImpactLog log_of(const std::vector<Event>& events) {
    ImpactLog log;
    log.observe(events, {});
    return log;
}

TEST(ImpactVerdict, TheSamePairAtAboutTheSameTimeIsTheSameImpact) {
    const auto exact = log_of({impact(1, 0, 3), impact(1.3, 0, 3), impact(1.32, 0, 4)});
    const auto verdict = judge(log_of({impact(1.28, 0, 3)}), exact, first_ball, apart, 1.33, 9);
    ASSERT_TRUE(verdict && verdict->error);
    EXPECT_NEAR(verdict->error->late, -0.02, 1e-12);
    EXPECT_FALSE(verdict->missed);
}

TEST(ImpactVerdict, WhatTheOtherNeverHadIsMissedOrTooMuchOnceItIsSettled) {
    const auto exact = log_of({impact(1, 0, 3), impact(1.5, 0, 4)});
    const auto contender = log_of({impact(1.01, 0, 3)});
    EXPECT_TRUE(judge(contender, exact, first_ball, apart, 1.55, 9)->error);
    const auto missed = judge(contender, exact, first_ball, apart, 1.65, 9);
    EXPECT_TRUE(missed->missed);
    EXPECT_EQ(missed->impact.other, Other::part(4));
    EXPECT_FALSE(missed->error);
    EXPECT_FALSE(judge(exact, contender, first_ball, apart, 1.55, 9));
    const auto extra = judge(exact, contender, first_ball, apart, 1.65, 9);
    EXPECT_FALSE(extra->missed);
    EXPECT_FALSE(extra->error);
    EXPECT_EQ(extra->impact.time, 1.5);
}

TEST(ImpactVerdict, OnlyOfThisBallOrPartAndOnlyWhatIsCertainAndPast) {
    const auto exact = log_of({impact(1, 0, 3), impact(2, 1, 3), impact(3, 0, 4)});
    const auto contender = log_of({impact(1.02, 0, 3), impact(2.03, 1, 3), impact(3.04, 0, 4)});
    const auto late = [&](Other subject, double now, double certain) {
        const auto verdict = judge(contender, exact, subject, apart, now, certain);
        return verdict && verdict->error ? verdict->error->late : 0;
    };
    EXPECT_NEAR(late(first_ball, 9, 9), 0.04, 1e-12);
    EXPECT_NEAR(late(Other::ball(1), 9, 9), 0.03, 1e-12);
    EXPECT_NEAR(late(Other::part(3), 9, 9), 0.03, 1e-12);
    EXPECT_NEAR(late(first_ball, 2.5, 9), 0.02, 1e-12);
    EXPECT_FALSE(judge(contender, exact, first_ball, apart, 9, 2.5));
    EXPECT_FALSE(judge(contender, exact, Other::ball(5), apart, 9, 9));
    EXPECT_FALSE(judge({}, {}, first_ball, apart, 9, 9));
}

TEST(ImpactLog, ForgetsWhatIsUndoneAndWhatIsOld) {
    ImpactLog log = log_of({impact(1, 0, 3), impact(2, 0, 4)});
    EXPECT_EQ(log.last(9)->event.time, 2);
    EXPECT_EQ(log.last(1.5)->event.time, 1);
    EXPECT_FALSE(log.last(0.5));
    log.forget_after(1.5);
    EXPECT_EQ(log.last(9)->event.time, 1);
    log.observe(std::vector{impact(31.5, 0, 5)}, {});
    EXPECT_FALSE(log.last(30));
    for (std::size_t i = 0; i < 2 * ImpactLog::most; ++i) log.observe(std::vector{impact(31.5, 1, 5)}, {});
    EXPECT_FALSE(log.last(first_ball, 40));
}

TEST(ImpactLog, KnowsWhatAnImpulseMakesOfASpeed) {
    std::vector<Ball> balls(2);
    balls[0].mass = 2;
    balls[1].mass = 3;
    balls[1].number = 7;
    Event part = impact(1, 7, 0), other = impact(1.5, 0, 0), gone = impact(2, 4, 0);
    part.speed = 2;
    part.impulse = 9;  // from −2 to +1 m/s
    other.other = Other::ball(7);
    other.speed = 1;
    other.impulse = 1.8;  // 1.8·(1/2 + 1/3) = 1.5
    ImpactLog log;
    log.observe(std::vector{part, other, gone}, balls);
    EXPECT_NEAR(*log.last(1)->leaving, 1, 1e-15);
    EXPECT_NEAR(*log.last(1)->restitution(), 0.5, 1e-15);
    EXPECT_NEAR(*log.last(1.5)->restitution(), 0.5, 1e-15);
    EXPECT_EQ(log.last(Other::ball(7), 9)->event.time, 1.5);
    EXPECT_FALSE(log.last(9)->leaving);
    EXPECT_FALSE(log.last(9)->restitution());
}

class ImpactsOfEngines : public testing::TestWithParam<const char*> {};

TEST_P(ImpactsOfEngines, TellTheRestitutionOfTheMaterial) {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 1.1}, {0.3, 0}).mass = 0.5;
    add_part(scene, segment({-5, 0}, {5, 0}), {"", 0.7, 0, 0});
    const Engine& engine = engine_named(GetParam());
    Session session(std::make_shared<const Scene>(scene), engine, Settings(engine.settings));
    ImpactLog log;
    for (int i = 0; i < 40; ++i) {
        session.step(1.0 / 60);
        log.observe(session.events(), session.world().balls());
    }
    ASSERT_TRUE(log.last(9));
    EXPECT_NEAR(*log.last(9)->restitution(), 0.7, 0.01);
    EXPECT_NEAR(log.last(9)->event.speed, std::sqrt(2 * 9.81), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Lab, ImpactsOfEngines, testing::Values("custom", "box2d", "reference"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace flipside::lab
