#pragma once
/// Where scenes and other files that come with the program are.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace flipside::lab {

/// $FLIPSIDE_ASSETS, else ../share/flipside as seen from the program's folder. An installation has it there,
/// and the build folder a link to the source tree's: so no program holds a path of the machine that built it.
[[nodiscard]] std::filesystem::path assets_folder();
/// The file of a scene given by its name in assets/scenes or by a path. Throws InputError that lists the
/// known names.
[[nodiscard]] std::filesystem::path scene_file(const std::string& name_or_path);
/// The script that comes with a scene: NAME.script.json beside NAME.json. Used where none is given.
[[nodiscard]] std::optional<std::filesystem::path> script_beside(const std::filesystem::path& scene_file);
/// The names of all scenes in assets/scenes, sorted.
[[nodiscard]] std::vector<std::string> scene_names();

}  // namespace flipside::lab
