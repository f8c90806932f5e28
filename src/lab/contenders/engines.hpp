#pragma once
/// The engines there are. To add one that is built in, list it in engines.cpp, which is all; libraries are
/// loaded by name.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/session/run_settings.hpp"

namespace flipside::lab {

/// Until the next library is loaded.
[[nodiscard]] std::span<const Engine* const> engines();
/// Those without one of these names: tables and figures that list solver variants of some engines take all
/// others as they come.
[[nodiscard]] std::vector<const Engine*> engines_beside(std::span<const std::string_view> names);
/// By its name, or by the path of a library that implements flipside/engine.h: what has a '/' in it. A
/// library that was loaded goes by its own name too. Throws InputError that lists the known ones, or says
/// what is wrong with the library.
[[nodiscard]] const Engine& engine_named(std::string_view name);
/// "box2d is Box2D 2.4.1": which library each engine is that is not ours.
[[nodiscard]] std::string libraries();
/// Where only one engine is used "NAME=VALUE" means it. Throws InputError for what is unknown or not
/// allowed, naming what is, and for engines that are not among those used.
[[nodiscard]] std::vector<SettingChange> parse_changes(std::span<const std::string> texts,
                                                       std::span<const Engine* const> used);

}  // namespace flipside::lab
