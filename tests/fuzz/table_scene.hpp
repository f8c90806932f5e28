#pragma once
/// The scene of the targets that read files which belong to a scene: it has a part of every kind.

#include <memory>

#include "world/scene.hpp"

namespace flipside::fuzz {

[[nodiscard]] const std::shared_ptr<const Scene>& table_scene();

}  // namespace flipside::fuzz
