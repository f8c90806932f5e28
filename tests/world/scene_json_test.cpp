#include "world/scene_json.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "places.hpp"
#include "world/scene_file.hpp"
#include "world/surface.hpp"

namespace flipside {
namespace {

std::vector<std::filesystem::path> shipped_scenes() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(test::source("assets/scenes")))
        if (!entry.path().stem().has_extension()) files.push_back(entry.path());
    return files;
}

TEST(SceneJson, EverySceneComesBackAsItWas) {
    ASSERT_GE(shipped_scenes().size(), 7U);
    for (const auto& file : shipped_scenes()) {
        SCOPED_TRACE(file);
        const Scene scene = load_scene(file);
        const std::string text = to_json(scene);
        const Scene back = parse_scene(text, "back");
        EXPECT_EQ(back.balls, scene.balls);
        EXPECT_EQ(back.name, scene.name);
        EXPECT_EQ(back.layers, scene.layers);
        EXPECT_EQ(back.recommend, scene.recommend);
        ASSERT_EQ(back.parts.size(), scene.parts.size());
        for (std::size_t i = 0; i < scene.parts.size(); ++i) {
            EXPECT_EQ(back.parts[i].name, scene.parts[i].name);
            EXPECT_EQ(back.parts[i].material, scene.parts[i].material);
            EXPECT_EQ(back.parts[i].motion.index(), scene.parts[i].motion.index());
            EXPECT_EQ(back.parts[i].target, scene.parts[i].target);
        }
        EXPECT_EQ(surface_of(back).size(), surface_of(scene).size());
        // Once in degrees and back, nothing is rounded any more.
        EXPECT_EQ(to_json(back), text);
    }
}

}  // namespace
}  // namespace flipside
