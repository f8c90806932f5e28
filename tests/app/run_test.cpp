#include "app/window/run.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "app/window/claim.hpp"
#include "fake_world.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {
namespace {

/// An engine whose one ball rests, whose claims get ten times worse with every step, and which refuses the
/// step that would end after 1 s.
class Doubter final : public test::FakeWorld {
  public:
    explicit Doubter(std::shared_ptr<const Scene> scene)
        : FakeWorld(std::vector<Ball>(1)), scene_(std::move(scene)) {
        balls_[0].radius = scene_->balls[0].radius;
        balls_[0].mass = scene_->balls[0].mass;
        uncertainty_[0] = 3e-14 * balls_[0].radius;
    }
    void step(double dt) override {
        if (time_ + dt > 1 + 1e-9) throw Refusal("doubter: it is not sure any more");
        FakeWorld::step(dt);
        uncertainty_[0] *= 10;
        statistics_.pair_tests = 7;
    }
    [[nodiscard]] std::span<const double> uncertainty() const override { return uncertainty_; }

  private:
    std::shared_ptr<const Scene> scene_;
    double uncertainty_[1]{};
};

const Engine doubter{"doubter",
                     "For tests.",
                     {},
                     [](std::shared_ptr<const Scene> scene, const Settings&) -> std::unique_ptr<World> {
                         return std::make_unique<Doubter>(std::move(scene));
                     }};

Run run_of_doubter() {
    auto scene = std::make_shared<const Scene>(
        parse_scene(R"({"format": "flipside-scene/1", "name": "one", "about": "A ball.",
                        "bounds": {"min": [-1, -1], "max": [1, 1]}, "gravity": [0, 0],
                        "balls": [{"position": [0, 0], "radius": 0.5, "mass": 1}], "parts": []})",
                    "test"));
    const lab::Contender contender{&doubter, Settings(doubter.settings), "doubter", 1};
    return {contender, lab::Session(scene, doubter, contender.settings), {}};
}

TEST(Run, StaysWhereItsEngineRefusedToGoOnAndSaysWhy) {
    auto run = run_of_doubter();
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(run.step_within(0.125, {}, 1));
    ASSERT_TRUE(run.halt());
    EXPECT_EQ(run.halt()->time, 1);
    EXPECT_EQ(run.halt()->reason, "doubter: it is not sure any more");
    EXPECT_EQ(run.session().world().time(), 1);
    EXPECT_FALSE(run.press(control::Nudge{{1, 0}}));
    EXPECT_EQ(run.numbers().back().time, 1);
    run.change(run.session().shared_scene(), {&doubter, Settings(doubter.settings), "doubter", 1});
    EXPECT_FALSE(run.halt());
}

TEST(Run, PassesTheHorizonWhereTheClaimEnds) {
    auto run = run_of_doubter();
    EXPECT_TRUE(run.uncertainty_history().empty());
    for (int i = 1; i <= 12; ++i) {
        EXPECT_TRUE(run.step_within(1.0 / 16, {}, 1));
        EXPECT_NEAR(run.uncertainty_history().back().value, 3 * std::pow(10.0, i - 14),
                    std::pow(10.0, i - 20));
    }
    EXPECT_FALSE(run.passed_horizon());
    EXPECT_TRUE(run.step_within(1.0 / 16, {}, 1));
    ASSERT_TRUE(run.passed_horizon());
    EXPECT_EQ(*run.passed_horizon(), 13.0 / 16);
    EXPECT_TRUE(run.step_within(1.0 / 16, {}, 1));
    EXPECT_EQ(*run.passed_horizon(), 13.0 / 16);
    run.change(run.session().shared_scene(), {&doubter, Settings(doubter.settings), "doubter", 1});
    EXPECT_FALSE(run.passed_horizon());
}

TEST(Run, KeepsTheNumbersOfItsLastStepWhileTheTableStandsStill) {
    auto run = run_of_doubter();
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(run.step_within(0.125, {}, 1));
    run.refresh(0.5);
    EXPECT_EQ(run.rates().pair_tests, 56);
    EXPECT_EQ(run.rates().pair_tests_per_step, 7);
    for (int i = 0; i < 2; ++i) run.refresh(0);
    EXPECT_EQ(run.rates().pair_tests, 56);
    EXPECT_EQ(run.rates().pair_tests_per_step, 7);
    EXPECT_EQ(run.rates().step_seconds, run.numbers().back().cost);
}

TEST(Run, StepsThatAreTracedDoNotCountInWhatAStepCosts) {
    auto run = run_of_doubter();
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(run.step_within(0.125, {}, 1));
    run.refresh(0.25);
    const double cost = run.step_cost(), rate = run.rates().step_seconds;
    Trace trace;
    run.trace(&trace);
    EXPECT_TRUE(run.step_within(0.125, {}, 1));
    run.trace(nullptr);
    run.refresh(0);
    EXPECT_FALSE(run.numbers().back().timed());
    EXPECT_EQ(run.step_cost(), cost);
    EXPECT_EQ(run.rates().step_seconds, rate);
    EXPECT_EQ(run.rates().pair_tests_per_step, 7);
    EXPECT_TRUE(run.step_within(0.125, {}, 1));
    run.refresh(0);
    EXPECT_TRUE(run.numbers().back().timed());
    EXPECT_EQ(run.rates().step_seconds, run.numbers().back().cost);
}

TEST(Claim, FadesWithTheDigitsFromSureToTheHorizon) {
    EXPECT_EQ(claim(0), 1);
    EXPECT_EQ(claim(1e-9), 1);
    EXPECT_DOUBLE_EQ(claim(1e-5), 0.5);
    EXPECT_NEAR(claim(1e-3), 0.25, 1e-15);
    EXPECT_EQ(claim(0.1), 0);
    EXPECT_EQ(claim(std::numeric_limits<double>::infinity()), 0);
}

}  // namespace
}  // namespace flipside::app
