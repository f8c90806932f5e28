#pragma once
/// The exact engine.

#include "world/engine.hpp"

namespace flipside::reference {

[[nodiscard]] const Engine& engine();

}  // namespace flipside::reference
