#pragma once
/// A control as a JSON object, in scripts and replays.

#include "world/controls.hpp"
#include "world/json_file.hpp"
#include "world/scene_names.hpp"

namespace flipside {

/// Its kind ("launch", "flip", ...) is under `key`.
[[nodiscard]] Json to_json(const Control& control, const Scene& scene, const char* key);
/// From an object whose form was checked. Throws InputError for what this scene does not have.
[[nodiscard]] Control read_control(const Node& node, const SceneNames& names, const char* key);

}  // namespace flipside
