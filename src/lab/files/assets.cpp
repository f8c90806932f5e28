#include "lab/files/assets.hpp"

#include <algorithm>
#include <cstdlib>

#include "world/input_error.hpp"

namespace flipside::lab {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view ending = ".json";

fs::path scenes_folder() {
    return assets_folder() / "scenes";
}

}  // namespace

fs::path assets_folder() {
    if (const char* chosen = std::getenv("FLIPSIDE_ASSETS")) return chosen;
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    return program.parent_path().parent_path() / "share" / "flipside";
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(scenes_folder(), failed)) {
        const fs::path file = entry.path().filename();
        // NAME.script.json is not a scene.
        if (file.extension() == ending && !file.stem().has_extension()) names.push_back(file.stem().string());
    }
    if (failed)
        throw InputError(
            scenes_folder().string(), "",
            "cannot be read (" + failed.message() + "); set FLIPSIDE_ASSETS to the assets folder");
    std::ranges::sort(names);
    return names;
}

fs::path scene_file(const std::string& name_or_path) {
    std::error_code why;
    const fs::file_type type = fs::status(name_or_path, why).type();
    if (type == fs::file_type::none)
        throw InputError(name_or_path, "", "cannot be read (" + why.message() + ")");
    if (type != fs::file_type::not_found && type != fs::file_type::directory) return name_or_path;
    const std::vector<std::string> names = scene_names();
    if (std::ranges::binary_search(names, name_or_path))
        return scenes_folder() / (name_or_path + std::string(ending));
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    throw InputError("no scene '" + name_or_path + "'; give the path of a file or one of " + known);
}

std::optional<fs::path> script_beside(const fs::path& scene_file) {
    const fs::path script = fs::path(scene_file).replace_extension("script.json");
    std::error_code unknown;  // its name may be too long to be one
    return fs::exists(script, unknown) ? std::optional(script) : std::nullopt;
}

}  // namespace flipside::lab
