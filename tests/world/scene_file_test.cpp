#include "world/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "world/input_error.hpp"

namespace flipside {
namespace {

const std::filesystem::path scenes = std::filesystem::path(FLIPSIDE_SOURCE_DIR) / "assets/scenes";

TEST(SceneFile, DropIsReadAsWritten) {
    const Scene scene = load_scene(scenes / "drop.json");
    EXPECT_EQ(scene.name, "drop");
    EXPECT_EQ(scene.gravity, (Vec2{0, -9.81}));
    EXPECT_EQ(scene.bounds, (Box{{-1, -0.5}, {1, 1.5}}));
    ASSERT_EQ(scene.balls.size(), 1U);
    EXPECT_EQ(scene.balls[0].position, (Vec2{0, 1.0135}));
    ASSERT_EQ(scene.parts.size(), 1U);
    EXPECT_EQ(scene.materials[scene.parts[0].material].restitution, 0.8);
    EXPECT_EQ(std::get<shape::Segment>(scene.parts[0].shape.is).b, (Vec2{0.8, 0}));
}

TEST(SceneFile, EverySceneThatComesWithTheProgramLoads) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scenes))
        if (entry.path().extension() == ".json") {
            EXPECT_NO_THROW((void)load_scene(entry.path())) << entry.path();
            ++count;
        }
    EXPECT_GE(count, 1);
}

}  // namespace
}  // namespace flipside
