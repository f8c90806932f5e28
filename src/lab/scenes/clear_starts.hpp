#pragma once
/// Scenes whose balls are placed without looking at what else is there.

#include "world/scene.hpp"

namespace flipside::lab {

/// Removes balls until none touches anything at the start, and numbers the others from 0. Of two that touch
/// each other the one with the smaller number goes.
/// Cost: making one world.
void clear_starts(Scene& scene);

}  // namespace flipside::lab
