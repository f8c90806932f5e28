#pragma once
/// The bespoke engine.

#include "world/engine.hpp"

namespace flipside::custom {

inline constexpr std::string_view engine_name = "custom";

[[nodiscard]] const Engine& engine();

}  // namespace flipside::custom
