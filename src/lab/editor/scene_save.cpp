#include "lab/editor/scene_save.hpp"

#include "lab/files/assets.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

namespace fs = std::filesystem;

namespace {

bool is_shipped(const fs::path& file) {
    std::error_code unknown;
    const fs::path assets = fs::weakly_canonical(assets_folder(), unknown);
    const fs::path relative = fs::weakly_canonical(file, unknown).lexically_relative(assets);
    return !relative.empty() && *relative.begin() != "..";
}

bool holds(const fs::path& file, const std::string& bytes) {
    try {
        return read_file(file) == bytes;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

SaveObstacle obstacle_to(const fs::path& target, const std::optional<OwnFile>& own) {
    std::error_code unknown;
    const bool is_own =
        own && fs::weakly_canonical(target, unknown) == fs::weakly_canonical(own->file, unknown);
    const bool there = fs::exists(fs::symlink_status(target, unknown));
    if (!is_own) return there ? SaveObstacle::taken : SaveObstacle::none;
    if (is_shipped(target)) return SaveObstacle::shipped;
    return !there || holds(target, own->bytes) ? SaveObstacle::none : SaveObstacle::changed;
}

fs::path typed_file(const std::string& typed) {
    fs::path file(typed);
    if (!file.has_extension()) file += ".json";
    return file;
}

fs::path free_scene_file(const fs::path& folder, const std::string& stem) {
    std::error_code unknown;
    fs::path file = folder / (stem + ".json");
    for (int i = 2; fs::exists(fs::symlink_status(file, unknown)); ++i)
        file = folder / (stem + "-" + std::to_string(i) + ".json");
    return file;
}

}  // namespace flipside::lab
