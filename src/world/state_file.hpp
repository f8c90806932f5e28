#pragma once
/// States as JSON: every double as the shortest text that reads back to the same bits.

#include <filesystem>
#include <string>
#include <string_view>

#include "world/scene.hpp"
#include "world/state.hpp"

namespace flipside {

[[nodiscard]] std::string to_json(const State& state, const Scene& scene);
/// Throws InputError when it is no state, or not one of this scene.
[[nodiscard]] State parse_state(std::string_view text, const std::string& file, const Scene& scene);
[[nodiscard]] State load_state(const std::filesystem::path& file, const Scene& scene);

}  // namespace flipside
