#pragma once
/// The engines there are. To add one, list it here.

#include <span>
#include <string_view>

#include "world/engine.hpp"

namespace flipside::lab {

[[nodiscard]] std::span<const Engine* const> engines();
/// Throws InputError that lists the known ones.
[[nodiscard]] const Engine& engine_named(std::string_view name);
/// The engine's defaults, changed by what the scene recommends for it.
[[nodiscard]] Settings settings_for(const Engine& engine, const Scene& scene);

}  // namespace flipside::lab
