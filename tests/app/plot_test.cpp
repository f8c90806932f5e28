#include "app/window/plot.hpp"

#include <cmath>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "app/window/plot_export.hpp"
#include "app/window/plots.hpp"
#include "lab/lessons/lesson.hpp"

namespace flipside::app {
namespace {

std::vector<Sample> every_tenth(double from, double to) {
    std::vector<Sample> samples;
    for (int i = static_cast<int>(std::lround(10 * from)); i <= static_cast<int>(std::lround(10 * to)); ++i)
        samples.push_back({0.1 * i, 1.0 * i});
    return samples;
}

TEST(Plot, CurvesEndAtTheBoxAndDoNotJoinGaps) {
    std::vector<Sample> samples = every_tenth(0, 3);
    const auto later = every_tenth(5, 8);
    samples.insert(samples.end(), later.begin(), later.end());
    samples[10].value = std::numeric_limits<double>::quiet_NaN();
    const auto runs = unbroken(samples, 0.45, 7.05, 0.25);
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_NEAR(runs[0].front().time, 0.5, 1e-12);
    EXPECT_NEAR(runs[0].back().time, 0.9, 1e-12);
    EXPECT_NEAR(runs[1].front().time, 1.1, 1e-12);
    EXPECT_NEAR(runs[1].back().time, 3, 1e-12);
    EXPECT_NEAR(runs[2].front().time, 5, 1e-12);
    EXPECT_NEAR(runs[2].back().time, 7, 1e-12);
    EXPECT_TRUE(unbroken({}, 0, 1, 0.1).empty());
    EXPECT_TRUE(unbroken(samples, 20, 30, 0.1).empty());
}

TEST(Plot, TicksAreRoundFewAndInside) {
    EXPECT_EQ(round_ticks(0, 10, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(round_ticks(-13, 2, 4), (std::vector<double>{-10, -5, 0}));
    EXPECT_EQ(round_ticks(1, 1, 4), std::vector<double>{});
    for (const double low : {-3.7, 0.0, 1e-9, 12345.6})
        for (const double span : {1e-12, 0.3, 7.0, 9e8})
            for (const int most : {2, 3, 7}) {
                const auto ticks = round_ticks(low, low + span, most);
                EXPECT_LE(ticks.size(), static_cast<std::size_t>(most)) << low << ' ' << span;
                for (const double tick : ticks) {
                    EXPECT_GE(tick, low - 1e-9 * std::abs(low));
                    EXPECT_LE(tick, (low + span) + 1e-9 * std::abs(low + span));
                }
            }
}

TEST(Plot, TimeFillsTheBoxAndThenGoesThroughIt) {
    EXPECT_EQ(span_until(0).from, 0);
    EXPECT_EQ(span_until(0).to, 0.5);
    EXPECT_EQ(span_until(3).from, 0);
    EXPECT_EQ(span_until(3).to, 3);
    EXPECT_EQ(span_until(100).from, 100 - history_seconds);
    EXPECT_EQ(span_until(100).to, 100);
}

TEST(Plot, ARangeHoldsItsCurves) {
    Plot plot{"t", "t"};
    plot.curves.push_back({"a", {}, {{0, 5}, {1, 7}, {2, 900}}, "", nullptr});
    fit(plot, 0, 1);
    EXPECT_LT(plot.bottom, 5);
    EXPECT_GT(plot.top, 7);
    EXPECT_LT(plot.top, 9);
    plot.curves.back().samples = {{0, 1}, {1, 7}};
    fit(plot, 0, 1);
    EXPECT_EQ(plot.bottom, 0);
}

/// A table without balls has an energy of 0 J, and not of some picojoules.
TEST(Plot, OfNothingTheRangeIsAUnit) {
    Plot plot{"t", "t"};
    plot.curves.push_back({"a", {}, {{0, 0}, {1, 0}}, "", nullptr});
    fit(plot, 0, 1);
    EXPECT_EQ(plot.bottom, 0);
    EXPECT_GE(plot.top, 1);
    EXPECT_LE(plot.top, 2);
}

/// A step that is twice as long may cost twice as much.
TEST(Plots, CompareTheCostOfUnequalStepsPerSimulatedSecond) {
    Stage stage("rain", "custom", View::split, {"custom.solver=simple"}, {});
    stage.step();
    const auto last = [&](std::size_t run) { return stage.runs()[run].numbers().back().cost; };
    const auto plotted = [&](std::size_t run) { return cost_plot(stage).curves[run].samples.back().value; };
    const double dt = stage.dt();
    EXPECT_EQ(plotted(1), last(1));
    stage.change_step(0, dt / 2);
    stage.step();
    EXPECT_EQ(stage.runs()[0].numbers().size(), 3U);
    EXPECT_NEAR(plotted(0) / (last(0) / (dt / 2)), 1, 1e-12);
    EXPECT_NEAR(plotted(1) / (last(1) / dt), 1, 1e-12);
    EXPECT_NEAR(stage.runs()[0].cost_per_second() * (dt / 2), stage.runs()[0].step_cost(), 1e-12);
}

TEST(Plots, EnergyIsNotJoinedAcrossAChangeOfGravityWhichIsMarked) {
    Stage stage("drop", "custom", View::split, {}, {});
    for (int i = 0; i < 6; ++i) stage.step();
    EXPECT_TRUE(energy_plot(stage).marks.empty());
    const double off = stage.time();
    stage.set_gravity(false);
    for (int i = 0; i < 6; ++i) stage.step();
    const double on = stage.time();
    stage.set_gravity(true);
    for (int i = 0; i < 6; ++i) stage.step();
    const Plot plot = energy_plot(stage);
    ASSERT_EQ(plot.marks.size(), 2U);
    EXPECT_EQ(plot.marks[0].words, "gravity off");
    EXPECT_EQ(plot.marks[0].time, off);
    EXPECT_EQ(plot.marks[1].words, "gravity on");
    EXPECT_EQ(plot.marks[1].time, on);
    for (const Curve& curve : plot.curves) {
        const auto pieces = unbroken(curve.samples, 0, stage.time(), 2.5 * stage.dt());
        ASSERT_EQ(pieces.size(), 3U);
        for (const auto& piece : pieces) EXPECT_EQ(piece.size(), 6U);
    }
}

TEST(Plots, ErrorsEndAtTheHorizonOfTheReference) {
    const lab::Lesson lesson = lab::load_lesson(lab::lesson_file("19"));
    Stage stage("rain", "custom", View::split, {}, {});
    stage.open(lesson);
    ASSERT_NE(stage.exact(), nullptr);
    for (int i = 0; i < 1000 && !stage.exact()->passed_horizon(); ++i) stage.step();
    ASSERT_TRUE(stage.exact()->passed_horizon());
    const double horizon = *stage.exact()->passed_horizon();
    for (int i = 0; i < 10; ++i) stage.step();
    const Plot plot = distance_plot(stage);
    for (const Sample& sample : plot.curves[0].samples)
        EXPECT_EQ(std::isfinite(sample.value), sample.time < horizon - 1e-9) << sample.time;
    EXPECT_GT(plot.curves.back().samples.back().value, 0.1) << "what it may be off by goes on";
}

TEST(Plots, ShowWhatEachStepCostAndFound) {
    Stage stage("rain", "custom", View::split, {"custom.solver=simple"}, {});
    for (int i = 0; i < 30; ++i) stage.step();
    const Plot tests = tests_plot(stage);
    ASSERT_EQ(tests.curves.size(), 2U);
    EXPECT_EQ(tests.curves[0].samples.size(), 30U);
    EXPECT_EQ(tests.curves[0].samples.back().value,
              static_cast<double>(stage.runs()[0].session().world().statistics().pair_tests));
    EXPECT_TRUE(std::isnan(tests.curves[1].samples.back().value)) << "Box2D does not count box tests";
    EXPECT_GT(cost_plot(stage).curves[1].samples.back().value, 0);
    EXPECT_EQ(distance_plot(stage).curves.size(), 1U);
    EXPECT_EQ(plots_of(PlotChoice::all, stage).size(), 4U);
    EXPECT_EQ(plots_of(PlotChoice::tests_and_cost, stage).size(), 2U);
    stage.set_view(View::single);
    EXPECT_EQ(plots_of(PlotChoice::all, stage).size(), 3U);
    EXPECT_GT(cost_plot(stage).curves.size(), 3U) << "alone also its stages";
    stage.go_to(0.25);
    const auto* numbers = numbers_at(stage.runs()[0].numbers(), stage.time());
    ASSERT_NE(numbers, nullptr);
    EXPECT_NEAR(numbers->time, 0.25, 1e-9);
}

TEST(Plots, AreExportedAsARowPerContenderAndStep) {
    Stage stage("drop", "custom", View::split, {}, {}, {"a=custom", "b=box2d,dt=1/120", "c=reference"});
    for (int i = 0; i < 10; ++i) stage.step();
    std::ostringstream out;
    write_numbers(out, stage);
    std::istringstream in(out.str());
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 1U + 10 + 20 + 10);
    const auto fields = std::ranges::count(lines[0], ',');
    for (const std::string& line : lines) EXPECT_EQ(std::ranges::count(line, ','), fields) << line;
    EXPECT_TRUE(lines[1].starts_with("a,custom,0.01666"));
    EXPECT_TRUE(lines[10].ends_with(",c"));
    EXPECT_TRUE(lines[11].starts_with("b,box2d,0.00833"));
    EXPECT_TRUE(lines.back().ends_with(",,"));
}

}  // namespace
}  // namespace flipside::app
