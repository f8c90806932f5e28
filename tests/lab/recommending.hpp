#pragma once
/// A scene that recommends settings.

#include <string>

#include "world/scene_file.hpp"

namespace flipside::lab {

/// Of a file my.json; `json` stands under its key "recommend".
inline Scene recommending(const std::string& json) {
    return parse_scene(
        R"({"format": "flipside-scene/1", "bounds": {"min": [0, 0], "max": [1, 1]}, "recommend": )" + json +
            "}",
        "my.json");
}

}  // namespace flipside::lab
