#pragma once
/// Box2D 2.4 behind the World interface.

#include "world/engine.hpp"

namespace flipside::box2d {

[[nodiscard]] const Engine& engine();

}  // namespace flipside::box2d
