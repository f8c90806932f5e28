#include "lab/session/run_settings.hpp"

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/recommending.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

std::string complaint_of(auto&& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

std::string complaint_about(const std::string& json) {
    const Scene scene = recommending(json);
    return complaint_of([&] { static_cast<void>(settings_for(engine_named("custom"), scene)); });
}

TEST(Recommended, WhatIsGoodIsTaken) {
    const std::string good =
        R"({"custom": {"motion_iterations": 9}, "box2d": {"substeps": 2}, "run": {"dt": 0.01}})";
    EXPECT_EQ(complaint_about(good), "none");
    EXPECT_EQ(settings_for(engine_named("custom"), recommending(good)).integer("motion_iterations"), 9);
    EXPECT_EQ(step_for(recommending(good)), 0.01);
}

TEST(Recommended, ErrorsNameFilePointerAndWhatIsAllowed) {
    const std::string unknown = complaint_about(R"({"custom": {"motion/iteration": 9}})");
    EXPECT_TRUE(unknown.starts_with("my.json: /recommend/custom/motion~1iteration: ")) << unknown;
    EXPECT_NE(unknown.find("motion_iterations"), std::string::npos) << unknown;
    const std::string wrong = complaint_about(R"({"custom": {"solver": "simpel"}})");
    EXPECT_TRUE(wrong.starts_with("my.json: /recommend/custom/solver: ")) << wrong;
    EXPECT_NE(wrong.find("simple"), std::string::npos) << wrong;
}

TEST(Recommended, StepsThatARunDoesNotTakeAreRefused) {
    for (const char* dt : {"1e-7", "2", "\"1/60\""}) {
        const std::string json = R"({"run": {"dt": )" + std::string(dt) + "}}";
        const std::string said = complaint_of([&] { static_cast<void>(step_for(recommending(json))); });
        EXPECT_TRUE(said.starts_with("my.json: /recommend/run/dt: ")) << said;
    }
}

TEST(Recommended, InASceneWithinAnotherFileArePointedToThere) {
    const Json document = parse_json(
        R"({"scene": {"format": "flipside-scene/1", "bounds": {"min": [0, 0], "max": [1, 1]},
                      "recommend": {"custom": {"solver": "simpel"}}}})",
        "my.json");
    const std::string file = "my.json";
    const Scene scene = parse_scene(Node(document, file).at("scene"));
    const std::string said =
        complaint_of([&] { static_cast<void>(settings_for(engine_named("custom"), scene)); });
    EXPECT_TRUE(said.starts_with("my.json: /scene/recommend/custom/solver: ")) << said;
}

}  // namespace
}  // namespace flipside::lab
