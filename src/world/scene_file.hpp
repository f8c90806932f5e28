#pragma once
/// Reads scenes: JSON whose form is checked against assets/scene.schema.json (compiled in), and whose
/// meaning is checked after it. What passes may be relied on by every engine (scene.hpp).

#include <filesystem>
#include <string_view>

#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/scene.hpp"

namespace flipside {

/// Throws InputError with file, JSON pointer, what is wrong and what is allowed.
[[nodiscard]] Scene load_scene(const std::filesystem::path& file);
/// The same from text; `file` is only named in errors.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file);

/// The same from a part of a document, whose form need not have been checked.
[[nodiscard]] Scene parse_scene(const Node& node);

/// The same scene with its generated field (see "generate" in the schema) made for `count` balls.
/// Throws InputError where the scene generates no field.
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, int count);

/// What is wrong with a ball of the start, by the pointer to that key of it in the scene's file; with a
/// generated one, by its number. `problem` begins with "is".
[[nodiscard]] InputError ball_error(const Scene& scene, BallNumber ball, const std::string& key,
                                    const std::string& problem);

}  // namespace flipside
