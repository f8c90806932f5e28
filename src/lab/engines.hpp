#pragma once
/// The engines there are. To add one, list it here.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "world/engine.hpp"

namespace flipside::lab {

[[nodiscard]] std::span<const Engine* const> engines();
/// Throws InputError that lists the known ones.
[[nodiscard]] const Engine& engine_named(std::string_view name);
/// A setting of one engine as the command line changes it: "ENGINE.NAME=VALUE".
struct SettingChange {
    const Engine* engine;
    std::string name, value;
};
/// Where only one engine is used "NAME=VALUE" means it. Throws InputError for what is unknown or not
/// allowed, naming what is, and for engines that are not among those used.
[[nodiscard]] std::vector<SettingChange> parse_changes(std::span<const std::string> texts,
                                                       std::span<const Engine* const> used);

/// The engine's defaults, changed by what the scene recommends for it, then by `changes` of this engine.
[[nodiscard]] Settings settings_for(const Engine& engine, const Scene& scene,
                                    std::span<const SettingChange> changes = {});
inline constexpr double default_step = 1.0 / 60;                 ///< s
inline constexpr double shortest_step = 1e-6, longest_step = 1;  ///< s
/// Seconds as a number or a fraction ("0.01", "1/60"). Throws InputError.
[[nodiscard]] double parse_step(std::string_view text);
/// The step that the scene recommends, s; default_step otherwise.
[[nodiscard]] double step_for(const Scene& scene);

}  // namespace flipside::lab
