#pragma once
/// The bespoke engine.

#include "world/engine.hpp"

namespace flipside::custom {

[[nodiscard]] const Engine& engine();

}  // namespace flipside::custom
