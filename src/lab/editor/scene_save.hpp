#pragma once
/// Writes a drawn scene, and no other file over by mistake.

#include <filesystem>
#include <optional>
#include <string>

namespace flipside::lab {

/// What stands in the way of writing a scene to a file.
enum class SaveObstacle {
    none,
    shipped,  ///< it comes with the program; another name is to be chosen
    changed,  ///< somebody else has written it since it was read
    taken     ///< there is another file of that name
};

/// `own`: where the scene was read from or last written to, with the bytes that were there then.
struct OwnFile {
    std::filesystem::path file;
    std::string bytes;
};

[[nodiscard]] SaveObstacle obstacle_to(const std::filesystem::path& target,
                                       const std::optional<OwnFile>& own);
/// The path that a user has typed, with ".json" behind it where it has no ending.
[[nodiscard]] std::filesystem::path typed_file(const std::string& typed);
/// In that folder, "STEM.json" or "STEM-2.json" ...: the first that is not there.
[[nodiscard]] std::filesystem::path free_scene_file(const std::filesystem::path& folder,
                                                    const std::string& stem);

}  // namespace flipside::lab
