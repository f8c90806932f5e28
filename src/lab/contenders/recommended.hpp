#pragma once
/// What scenes recommend for engines, against the engines there are.

#include "world/scene.hpp"

namespace flipside::lab {

/// Throws InputError, with file and JSON pointer, where the scene recommends settings for an engine that is
/// neither built in nor loaded.
void require_known_engines(const Scene& scene);

}  // namespace flipside::lab
