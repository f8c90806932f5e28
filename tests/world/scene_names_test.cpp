#include "world/scene_names.hpp"

#include <ctime>

#include "world/ball_json.hpp"
#include "world/scene_builder.hpp"
#include "world/script_file.hpp"
#include "world/support.hpp"

namespace flipside {
namespace {

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

TEST(SceneNames, FindWhatTheSceneHas) {
    const Scene scene = scene_with_everything();
    const SceneNames names(scene);
    for (PartIndex i = 0; i < scene.parts.size(); ++i) EXPECT_EQ(names.part(scene.parts[i].name), i);
    for (std::uint32_t i = 1; i < scene.materials.size(); ++i)
        EXPECT_EQ(names.material(scene.materials[i].name), i);
    for (const char* unknown : {"", "dro", "drop 11", "zebra"}) {
        EXPECT_FALSE(names.part(unknown)) << unknown;
        EXPECT_FALSE(names.material(unknown)) << unknown;
    }
}

TEST(SceneNames, OfTwoThingsTheFirstIsFound) {
    Scene scene = empty_scene();
    for (const char* name : {"b", "a", "b", "a"}) add_part(scene, segment({}, {1, 0})).name = name;
    EXPECT_EQ(SceneNames(scene).part("a"), 1U);
    EXPECT_EQ(SceneNames(scene).part("b"), 0U);
}

// Each name was once compared with all that come before it in the scene, for half a minute in all.
TEST(SceneNames, OfManyTargetsAreFoundInNoTime) {
    constexpr PartIndex many = 100'000, in_one = 1'000;
    Scene scene = empty_scene();
    Json controls = Json::array();
    for (PartIndex i = 0; i < many; ++i) {
        add_part(scene, segment({}, {1, 0})).target = true;
        if (i % in_one == 0) controls.push_back({{"time", 0}, {"control", "raise_targets"}, {"parts", {}}});
        controls.back()["parts"].push_back(scene.parts[i].name);
    }
    const Json document = {{"format", "flipside-script/1"}, {"controls", controls}};
    const std::string file = "s.json";
    const double began = cpu_seconds();
    const Script script = parse_script(Node(document, file), scene);
    EXPECT_LT(cpu_seconds() - began, 3);
    ASSERT_EQ(script.size(), many / in_one);
    EXPECT_EQ(std::get<control::RaiseTargets>(script.back().control).parts.back(), many - 1);
}

TEST(SceneNames, OfBallsOfManyMaterialsAreFoundInNoTime) {
    constexpr std::uint32_t many = 100'000;
    Scene scene = empty_scene();
    const std::string file = "s.json";
    for (std::uint32_t i = 0; i < many; ++i) scene.materials.push_back({"of " + std::to_string(i), 1, 0, 0});
    const SceneNames names(scene);
    Ball ball;
    ball.radius = ball.mass = 1;
    const double began = cpu_seconds();
    for (ball.material = 1; ball.material <= many; ++ball.material) {
        const Json json = to_json(ball, scene);
        ASSERT_EQ(read_ball(Node(json, file), names).material, ball.material);
    }
    EXPECT_LT(cpu_seconds() - began, 5);
}

}  // namespace
}  // namespace flipside
