#pragma once
/// Worlds of this engine, of scenes made in code.

#include <memory>

#include "custom/engine.hpp"
#include "world/scene_builder.hpp"

namespace flipside::custom::test {

inline std::unique_ptr<World> make_world(
    const Scene& scene, std::initializer_list<std::pair<std::string_view, std::string_view>> settings = {}) {
    Settings values(engine().settings);
    for (const auto& [name, value] : settings) values.set(name, value);
    return engine().make(std::make_shared<const Scene>(scene), values);
}

inline void run(World& world, double seconds, double dt = 1.0 / 60) {
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    for (int i = 0; i < steps; ++i) world.step(dt);
}

}  // namespace flipside::custom::test
