#pragma once
/// A ball as a JSON object, in states and replays.

#include "world/json_file.hpp"
#include "world/scene_names.hpp"

namespace flipside {

[[nodiscard]] Json to_json(const Ball& ball, const Scene& scene);
/// From an object whose form was checked. Throws InputError for what this scene does not have.
[[nodiscard]] Ball read_ball(const Node& node, const SceneNames& names);

}  // namespace flipside
