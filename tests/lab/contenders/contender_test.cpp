#include "lab/contenders/contender.hpp"

#include <gtest/gtest.h>

#include "lab/comparison/compare.hpp"
#include "lab/contenders/engines.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

std::vector<ContenderRequest> parsed(const std::vector<std::string>& texts) {
    return parse_contenders(texts);
}

void expect_contenders_refused(const std::vector<std::string>& texts, const std::string& words) {
    try {
        static_cast<void>(parsed(texts));
        ADD_FAILURE() << texts.back() << " was taken";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

Scene falling_ball() {
    return parse_scene(R"({"format": "flipside-scene/1", "name": "fall", "about": "A ball falls.",
        "bounds": {"min": [-9, -99], "max": [9, 9]}, "gravity": [0, -10],
        "recommend": {"custom": {"solver": "simple"}},
        "balls": [{"position": [0, 0], "radius": 0.5, "mass": 1}], "parts": []})",
                       "test");
}

TEST(Contender, IsAnEngineWithItsStepAndItsSettings) {
    const auto requests = parsed({"fine=box2d,dt=1/240,substeps=4", "custom=custom"});
    ASSERT_EQ(requests.size(), 2U);
    const Scene scene = falling_ball();
    const Contender fine = contender_for(requests[0], scene, 0.1);
    EXPECT_EQ(fine.name, "fine");
    EXPECT_EQ(fine.engine->name, "box2d");
    EXPECT_EQ(fine.dt, 1.0 / 240);
    EXPECT_EQ(fine.settings.integer("substeps"), 4);
    const Contender plain = contender_for(requests[1], scene, 0.1);
    EXPECT_EQ(plain.dt, 0.1);
    EXPECT_EQ(plain.settings.choice("solver"), "simple");
}

TEST(Contender, ItsOwnSettingsWinOverTheScenesAndTheEngines) {
    const Scene scene = falling_ball();
    const SettingChange change{&engine_named("custom"), "motion_iterations", "3"};
    const auto requests = parsed({"a=custom", "b=custom,motion_iterations=7,solver=continuous"});
    EXPECT_EQ(contender_for(requests[0], scene, 0.1, {&change, 1}).settings.integer("motion_iterations"), 3);
    const Contender b = contender_for(requests[1], scene, 0.1, {&change, 1});
    EXPECT_EQ(b.settings.integer("motion_iterations"), 7);
    EXPECT_EQ(b.settings.choice("solver"), "continuous");
}

TEST(Contender, RefusesWhatIsNone) {
    for (const char* text : {"", "custom", "=custom", "a=custom,", "a=custom,,dt=1", "a=custom,dt"})
        expect_contenders_refused({text}, "NAME=ENGINE[,dt=1/240][,K=V]...");
    expect_contenders_refused({"a=oddity"}, "known are custom, box2d, reference");
    expect_contenders_refused({"a\x1b[2J=custom"}, "no name");
    expect_contenders_refused({"a=custom,dt=2"}, "contender 'a': step '2' is not allowed");
    expect_contenders_refused({"a=custom,dt=0"}, "is not allowed");
    expect_contenders_refused({"a=custom,dt=1/60,dt=1/240"}, "contender 'a': 'dt' is given twice");
    expect_contenders_refused({"a=custom,sleep=on,sleep=on"}, "contender 'a': 'sleep' is given twice");
    expect_contenders_refused({"a=custom,substeps=2"}, "contender 'a': ");
    expect_contenders_refused({"a=custom", "a=box2d"}, "'a' is there twice");
}

TEST(Contender, MeetsTheOthersAtTheEndOfTheLongestStep) {
    const auto step_of = [](const std::vector<std::string>& texts) {
        std::vector<Contender> contenders;
        for (const auto& request : parsed(texts))
            contenders.push_back(contender_for(request, falling_ball(), 1.0 / 60));
        return common_step(contenders);
    };
    EXPECT_EQ(step_of({"a=custom"}), 1.0 / 60);
    EXPECT_EQ(step_of({"a=custom,dt=1/240", "b=box2d,dt=1/30", "c=reference"}), 1.0 / 30);
    EXPECT_EQ(step_of({"a=custom,dt=0.1", "b=custom,dt=1e-6"}), 0.1);
    EXPECT_THROW(step_of({"a=custom,dt=1/97", "b=custom"}), InputError);
}

TEST(Contender, GetsTheFirstFreeName) {
    const auto taken = parsed({"custom=custom", "custom-2=custom", "box2d=box2d"});
    EXPECT_EQ(free_name("custom", taken), "custom-3");
    EXPECT_EQ(free_name("reference", taken), "reference");
}

TEST(Contender, InAComparisonTakesItsOwnSteps) {
    CompareInput input;
    input.scene = std::make_shared<const Scene>(falling_ball());
    for (const auto& request :
         parsed({"truth=reference,dt=1/30", "coarse=box2d,dt=1/30", "fine=box2d,dt=1/240"}))
        input.contenders.push_back(contender_for(request, *input.scene, 1.0 / 30));
    input.seconds = 0.51;
    const Comparison result = compare(input);
    EXPECT_EQ(result.dt, 1.0 / 30);
    EXPECT_EQ(result.times.size(), 16U);
    EXPECT_EQ(result.times.back(), 0.51);
    EXPECT_EQ(result.runs[1].figures.totals.steps, 16U);
    EXPECT_EQ(result.runs[2].figures.totals.steps, 123U);  // 15 · 8, then 2 whole ones and a rest
    // Semi-implicit Euler falls g·dt·t/2 too far: eight times less with an eighth of the step.
    const auto error = [&](std::size_t pair, double dt) {
        EXPECT_NEAR(result.pairs[pair].radii[14] * 0.5, 10 * dt * 0.5 / 2, 1e-5);
    };
    error(0, 1.0 / 30);
    error(1, 1.0 / 240);
    EXPECT_FALSE(result.runs[0].blame);  // is the reference
    ASSERT_TRUE(result.runs[1].blame);
    EXPECT_FALSE(result.runs[1].blame->blame);  // less than a radius off
    EXPECT_EQ(result.runs[1].blame->until, 0.51);
}

/// One that is only added to the list of engines takes part everywhere, as it comes: box2d, where no table
/// speaks of it.
TEST(Engines, OfWhichNoTableSpeaksAreTheOthers) {
    constexpr std::string_view listed[] = {"custom", "reference"};
    const auto others = engines_beside(listed);
    ASSERT_FALSE(others.empty());
    EXPECT_EQ(others.front(), &engine_named("box2d"));
    EXPECT_EQ(others.size() + 2, engines().size());
    EXPECT_EQ(engines_beside({}).size(), engines().size());
}

}  // namespace
}  // namespace flipside::lab
