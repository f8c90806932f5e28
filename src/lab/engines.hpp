#pragma once
/// The engines there are. To add one, list it here.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/run_settings.hpp"

namespace flipside::lab {

[[nodiscard]] std::span<const Engine* const> engines();
/// Throws InputError that lists the known ones.
[[nodiscard]] const Engine& engine_named(std::string_view name);
/// "box2d is Box2D 2.4.1": which library each engine is that is not ours.
[[nodiscard]] std::string libraries();
/// Where only one engine is used "NAME=VALUE" means it. Throws InputError for what is unknown or not
/// allowed, naming what is, and for engines that are not among those used.
[[nodiscard]] std::vector<SettingChange> parse_changes(std::span<const std::string> texts,
                                                       std::span<const Engine* const> used);

}  // namespace flipside::lab
