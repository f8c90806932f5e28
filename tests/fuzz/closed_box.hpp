#pragma once
/// Scenes out of which no ball may come.

#include <memory>

#include "world/scene.hpp"

namespace flipside::fuzz {

/// The scene with a wall around its balls and no launcher. Null where balls could get out for a good reason:
/// they overlap something at the start, pass walls by their layers, gain speed without end, or are pushed by
/// moving parts.
[[nodiscard]] std::shared_ptr<const Scene> closed_box(const Scene& scene);

}  // namespace flipside::fuzz
