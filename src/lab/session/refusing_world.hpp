#pragma once
/// What stands for a world that an engine could not make, where others go on beside it: its balls stay where
/// they are and its first step is refused for the reason that the engine gave.

#include <memory>

#include "world/engine.hpp"

namespace flipside::lab {

/// The engine's world, or one that refuses where the engine throws InputError or Refusal.
[[nodiscard]] std::unique_ptr<World> world_or_refusal(const Engine& engine,
                                                      const std::shared_ptr<const Scene>& scene,
                                                      const Settings& settings);

}  // namespace flipside::lab
