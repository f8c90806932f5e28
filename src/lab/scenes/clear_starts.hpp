#pragma once
/// Scenes whose balls are placed without looking at what else is there.

#include "world/scene.hpp"

namespace flipside::lab {

/// Removes the balls that touch something at the start, and numbers the others from 0.
/// Cost: an engine is made anew for each one that is removed.
void clear_starts(Scene& scene);

}  // namespace flipside::lab
