#pragma once
/// Scripts as JSON: {"format": "flipside-script/1", "controls": [{"time": 0.5, "control": "launch", …}]}.

#include <filesystem>
#include <string>
#include <string_view>

#include "world/controls.hpp"
#include "world/json_file.hpp"

namespace flipside {

[[nodiscard]] std::string to_json(const Script& script, const Scene& scene);
[[nodiscard]] Json script_document(const Script& script, const Scene& scene);
/// Throws InputError with file, JSON pointer, what is wrong and what is allowed.
[[nodiscard]] Script parse_script(std::string_view text, const std::string& file, const Scene& scene);
/// The same from a part of a document, whose form need not have been checked.
[[nodiscard]] Script parse_script(const Node& node, const Scene& scene);
[[nodiscard]] Script load_script(const std::filesystem::path& file, const Scene& scene);

}  // namespace flipside
