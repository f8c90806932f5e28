#include "lab/sweep/measure.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "world/refusal.hpp"

namespace flipside::lab::sweep {
namespace {

Event impact(double time, BallNumber ball, Other other) {
    return {time, EventKind::impact, ball, other, {}, {}, 1, 0};
}

TEST(Unmatched, ImpactsMatchByBallOtherAndTime) {
    const std::vector first{impact(0.1, 0, Other::part(3)), impact(0.2, 1, Other::part(3)),
                            impact(0.3, 0, Other::ball(1)), impact(0.5, 0, Other::part(3))};
    std::vector second = first;
    std::swap(second[0], second[1]);  // the order between balls means nothing
    EXPECT_EQ(count_unmatched(first, second, 0.01, 1).first, 0U);
    second[2].time += 0.02;  // late: it is missed, and another one is spurious
    second.pop_back();
    EXPECT_EQ(count_unmatched(first, second, 0.01, 1).first, 2U);
    EXPECT_EQ(count_unmatched(first, second, 0.01, 1).second, 1U);
    EXPECT_EQ(count_unmatched(first, second, 0.03, 1).first, 1U);
    EXPECT_EQ(count_unmatched(first, second, 0.03, 1).second, 0U);
    second[2].other = Other::part(1);  // number 1, but no ball
    EXPECT_EQ(count_unmatched(first, second, 0.03, 1).second, 1U);
}

TEST(Unmatched, OneTooManyInARowIsOneTooMany) {
    const std::vector first{impact(0.1, 0, Other::part(3)), impact(0.14, 0, Other::part(3))};
    const std::vector second{impact(0.1, 0, Other::part(3)), impact(0.12, 0, Other::part(3)),
                             impact(0.14, 0, Other::part(3))};
    EXPECT_EQ(count_unmatched(first, second, 0.01, 1).first, 0U);
    EXPECT_EQ(count_unmatched(first, second, 0.01, 1).second, 1U);
}

TEST(Unmatched, TheEndMayHideAMatch) {
    const std::vector late{impact(0.995, 0, Other::part(3))};
    EXPECT_EQ(count_unmatched(late, {}, 0.01, 1).first, 0U);
    EXPECT_EQ(count_unmatched({}, late, 0.01, 1).second, 0U);
    EXPECT_EQ(count_unmatched(late, {}, 0.001, 1).first, 1U);
}

/// Falls freely by the formula, and fails as told.
class Scripted final : public World {
  public:
    enum class Fate { fall, refuse, vanish, nan };
    explicit Scripted(Fate fate) : fate_(fate) {}

    void step(double dt) override {
        if (fate_ == Fate::refuse) throw Refusal("scripted: ball 0 at 0 s: it is told to");
        for (Ball& ball : state_.balls) ball.position += dt * ball.velocity;
        state_.clock.advance(dt);
        if (fate_ == Fate::nan) state_.balls.back().position.y = std::nan("");
        if (fate_ == Fate::vanish) state_.balls.resize(1);
    }
    void apply(const Control&) override {}
    BallNumber add(const Ball&) override { return 0; }
    bool remove(BallNumber) override { return false; }
    [[nodiscard]] Clock clock() const override { return state_.clock; }
    [[nodiscard]] std::span<const Ball> balls() const override { return state_.balls; }
    [[nodiscard]] std::span<const PartState> parts() const override { return {}; }
    [[nodiscard]] std::span<const Event> events() const override { return {}; }
    [[nodiscard]] std::span<const Contact> contacts() const override { return {}; }
    [[nodiscard]] const Statistics& statistics() const override { return statistics_; }
    [[nodiscard]] State save() const override { return state_; }
    void restore(const State& state) override { state_ = state; }
    void inspect(Inspector&) const override {}
    void trace(Trace*) override {}

  private:
    Fate fate_;
    State state_;
    Statistics statistics_;
};

/// Two balls at 1 and 2 m/s for 0.1 s whose exact ends are a quarter and a half radius further.
Window two_balls() {
    Window window;
    window.seconds = 3 * window_unit;
    window.start.balls.resize(2);
    for (BallNumber i = 0; i < 2; ++i) {
        Ball& ball = window.start.balls[i];
        ball.number = i;
        ball.radius = 0.5;
        ball.velocity = {1.0 + i, 0};
        window.ends.push_back({i, {0.1 * (1 + i) + 0.125 * (1 + i), 0}, ball.radius, 0, i == 0});
    }
    window.impacts = {impact(0.05, 0, Other::part(0))};
    return window;
}

TEST(RunWindow, TellsTheWorstBallAndTheTypicalOneThatWasHit) {
    Scripted world(Scripted::Fate::fall);
    History history;
    const Outcome outcome = run_window(world, two_balls(), 1.0 / 60, history);
    EXPECT_EQ(outcome.failure, "");
    EXPECT_NEAR(outcome.error, 0.5, 1e-12);
    EXPECT_NEAR(outcome.typical, 0.25, 1e-12);
    EXPECT_EQ(outcome.impacts, 1U);
    EXPECT_EQ(outcome.missed, 1U);
    EXPECT_EQ(outcome.spurious, 0U);
    EXPECT_GE(time_window(world, two_balls(), 1.0 / 60), 0);
}

TEST(RunWindow, NamesFailures) {
    const std::pair<Scripted::Fate, const char*> fates[] = {{Scripted::Fate::refuse, "refused"},
                                                            {Scripted::Fate::vanish, "lost ball"},
                                                            {Scripted::Fate::nan, "not a number"}};
    for (const auto& [fate, name] : fates) {
        Scripted world(fate);
        History history;
        const Outcome outcome = run_window(world, two_balls(), 1.0 / 30, history);
        EXPECT_EQ(outcome.failure, name);
        EXPECT_EQ(outcome.error, std::numeric_limits<double>::infinity());
        EXPECT_EQ(outcome.typical, std::numeric_limits<double>::infinity());
    }
    Scripted slow(Scripted::Fate::fall);
    History history;
    EXPECT_EQ(run_window(slow, two_balls(), 1.0 / 30, history, 0).failure, "refused");
    EXPECT_EQ(history.steps(), 1U);
    Scripted refusing(Scripted::Fate::refuse);
    EXPECT_TRUE(std::isnan(time_window(refusing, two_balls(), 1.0 / 30)));
}

}  // namespace
}  // namespace flipside::lab::sweep
