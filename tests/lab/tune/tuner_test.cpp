#include "lab/tune/tuner.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lab/sweep/contenders.hpp"
#include "lab/tune/tune.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::tune {
namespace {

sweep::Variant one_ball() {
    return sweep::variants_of({"pinball"}, 1).front();
}

void nothing() {}

TEST(Tuner, MeetsAnErrorThatTheEngineAsItComesMissesAtAnyStep) {
    const Trials trials(one_ball(), 3, Trials::search_block, 8, nothing);
    const Engine& box2d = engine_named("box2d");
    const Found plain = untuned(box2d, trials, 120, 1e-9);
    EXPECT_EQ(plain.contender.dt, 1.0 / 120);
    const double target = 0.4 * plain.score.error;
    const Found found = Tuner(box2d, trials, 120, 600).cheapest(target);
    EXPECT_LE(found.score.error, target);
    EXPECT_LE(found.score.error, trials.error(found.contender)) << "as is measured again";
    EXPECT_NE(found.contender.settings, settings_for(box2d, trials.scene()));
    EXPECT_GT(found.tried, 20U);
}

TEST(Tuner, FindsWhatCostsLess) {
    const Trials trials(one_ball(), 3, Trials::search_block, 8, nothing);
    // The simple solver's cost grows with its iterations: of an error that all meet, few are the cheapest.
    const Engine& custom = engine_named("custom");
    const Found found = Tuner(custom, trials, 120, 600).cheapest(1e3);
    EXPECT_LE(found.score.error, 1e3);
    Contender dear = found.contender;
    dear.settings.set("solver", "simple");
    dear.settings.set("motion_iterations", 64);
    const std::vector<std::vector<double>> times = trials.times(std::vector{found.contender, dear});
    ASSERT_EQ(times[0].size(), 8U);
    for (std::size_t i = 0; i < times[0].size(); ++i) EXPECT_LT(times[0][i], times[1][i]);
}

TEST(Tuner, BeginsNoTrialAfterItsTime) {
    const Trials trials(one_ball(), 3, Trials::search_block, 8, nothing);
    const Found found = Tuner(engine_named("box2d"), trials, 120, 1e-9).cheapest(1e-9);
    EXPECT_EQ(found.tried, 2U) << "the engine as it comes, from both places";
    EXPECT_TRUE(std::isfinite(found.score.error));
}

TEST(Trials, GiveUpWhatIsTooDearOrTooWrong) {
    const Trials trials(one_ball(), 3, Trials::search_block, 8, nothing);
    const Engine& box2d = engine_named("box2d");
    const Contender plain{&box2d, settings_for(box2d, trials.scene()), "box2d", 1.0 / 60};
    EXPECT_EQ(trials.score(plain, 1e9, 1e-12).error, INFINITY);
    EXPECT_EQ(trials.score(plain, 1e-9, 1e9).error, INFINITY);
    const Score score = trials.score(plain, 1e9, 1e9);
    EXPECT_EQ(score.error, trials.error(plain));
    EXPECT_GT(score.cost, 0);
    EXPECT_LT(score.cost, 1);
}

TEST(Trials, NeedWindows) {
    // A ball in empty space hits nothing.
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("flipside-space-" + std::to_string(getpid()) + ".json");
    std::ofstream(file) << R"({"format": "flipside-scene/1", "name": "space", "about": "One ball.",
        "bounds": {"min": [-1, -1], "max": [1, 1]}, "gravity": [0, 0], "materials": {"steel": {"restitution": 1}},
        "balls": [{"position": [0, 0], "radius": 0.01, "mass": 0.1, "material": "steel"}], "parts": []})";
    const sweep::Variant space{.name = "space", .scene = file.string()};
    EXPECT_THROW(Trials(space, 1, 0, 2, nothing), InputError);
    std::filesystem::remove(file);
}

TEST(Tune, JudgesOnWindowsThatNobodyWasTunedOn) {
    const Request request{.engine = &engine_named("box2d"), .targets = {0.5, 2}, .windows = 6, .finest = 120};
    double last = -1;
    const auto all = tune(request, one_ball(), [&](double done) { last = done; });
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(last, 1);
    EXPECT_EQ(all[0].target, 2) << "the largest first";
    for (const Tuning& tuning : all) {
        EXPECT_EQ(tuning.variant, "pinball-1");
        EXPECT_LT(tuning.ours.score.error, 1e-9);
        EXPECT_EQ(tuning.ours.contender.dt, 1.0 / 30) << "exact at the longest step";
        EXPECT_TRUE(tuning.tuned.text.starts_with("box2d-tuned=box2d,dt=") ||
                    tuning.tuned.text == tuning.untuned.text);
        if (tuning.untuned.score.error <= tuning.target) {
            EXPECT_LE(tuning.tuned.score.error, tuning.target);
            EXPECT_LE(tuning.tuned.score.cost, tuning.untuned.score.cost);
        }
        ASSERT_TRUE(tuning.over_ours && tuning.over_untuned);
        EXPECT_LE(tuning.over_ours->low, tuning.over_ours->value);
        EXPECT_LE(tuning.over_ours->value, tuning.over_ours->high);
        EXPECT_GT(tuning.over_ours->low, 0);
    }
    const Trials other(one_ball(), request.seed, Trials::check_block, 6, nothing);
    EXPECT_EQ(all[0].tuned.score.error, other.error(all[0].tuned.contender));
}

TEST(Tune, OursIsTheContinuousSolverAlsoWhereASceneAsksForTheSimpleOne) {
    const Request request{.engine = &engine_named("box2d"), .targets = {1e3}, .windows = 2, .finest = 30};
    const auto all = tune(request, sweep::variants_of({"toy"}, 0).front(), [](double) {});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_LT(all[0].ours.score.error, 1e-9);
    EXPECT_NE(all[0].ours.text.find("solver=continuous"), std::string::npos) << all[0].ours.text;
}

}  // namespace
}  // namespace flipside::lab::tune
