#pragma once
/// How an engine offers itself. Each engine's folder defines one of these; lab/contenders/engines.hpp lists
/// them.

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "world/scene.hpp"
#include "world/settings.hpp"
#include "world/world.hpp"

namespace flipside {

struct Engine {
    std::string_view name;   ///< as on the command line
    std::string_view about;  ///< one line
    std::span<const SettingSpec> settings;
    /// Makes a world at time 0 with the scene's balls. Throws InputError for a scene it cannot run; an engine
    /// in a process of its own also Refusal, where that ends.
    std::function<std::unique_ptr<World>(std::shared_ptr<const Scene> scene, const Settings& settings)> make;
    /// Name and version of the library that it is, as "Box2D 2.4.1"; empty where it is ours. Belongs beside
    /// every figure of its speed.
    std::string_view library{};
    /// A world that a state is restored into goes on with the same bits as the one that saved it.
    bool restores_exactly = false;
    std::string_view file{};  ///< from which it was loaded; empty where it is built in
};

}  // namespace flipside
