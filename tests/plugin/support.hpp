#pragma once
/// Worlds of the engines that are made for these tests.

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"

namespace flipside::plugin {

inline std::shared_ptr<const Scene> scene_of(const std::string& rest) {
    return std::make_shared<const Scene>(parse_scene(
        R"({"format": "flipside-scene/1", "name": "test", "bounds": {"min": [-9, -9], "max": [9, 9]}, )" +
            rest + "}",
        "test"));
}

/// Balls in the air, side by side, and a point below.
inline std::shared_ptr<const Scene> falling(int count) {
    std::string balls;
    for (int i = 0; i < count; ++i)
        balls += std::string(i == 0 ? "" : ", ") + R"({"position": [)" + std::to_string(i) +
                 R"(, 0], "velocity": [0, 1], "radius": 0.1, "mass": 1})";
    return scene_of(R"("gravity": [0, -10], "balls": [)" + balls +
                    R"(], "parts": [{"name": "pin", "shape": {"type": "point", "at": [-5, -5]}}])");
}

inline std::unique_ptr<World> world_of(const char* library, const std::shared_ptr<const Scene>& scene,
                                       const std::string& change = "") {
    const Engine* const engine = &lab::engine_named(library);
    std::vector<std::string> texts;
    if (!change.empty()) texts.push_back(change);
    return engine->make(scene, lab::settings_for(*engine, *scene, lab::parse_changes(texts, {&engine, 1})));
}

/// What the refusal of a step says; "" where there is none in half a second.
inline std::string refusal_of(World& world) {
    try {
        for (int i = 0; i < 50; ++i) world.step(0.01);
    } catch (const Refusal& refusal) {
        return refusal.what();
    }
    return "";
}

}  // namespace flipside::plugin
