#pragma once
/// The settings and the step that a scene is run with.

#include <span>
#include <string>
#include <string_view>

#include "world/engine.hpp"

namespace flipside::lab {

/// A setting of one engine as the command line changes it: "ENGINE.NAME=VALUE".
struct SettingChange {
    const Engine* engine;
    std::string name, value;
};
/// The engine's defaults, changed by what the scene recommends for it, then by `changes` of this engine.
/// Throws InputError, with file and JSON pointer, where the scene recommends what this engine does not take.
/// Names of engines are for lab/contenders/recommended.hpp.
[[nodiscard]] Settings settings_for(const Engine& engine, const Scene& scene,
                                    std::span<const SettingChange> changes = {});
inline constexpr double default_step = 1.0 / 60;                 ///< s
inline constexpr double shortest_step = 1e-6, longest_step = 1;  ///< s
/// Seconds as a number or a fraction ("0.01", "1/60"). Throws InputError.
[[nodiscard]] double parse_step(std::string_view text);
/// The step that the scene recommends, s; default_step otherwise.
[[nodiscard]] double step_for(const Scene& scene);

}  // namespace flipside::lab
