#pragma once
/// A picture of a scene at a moment, drawn as the window draws it. Needs an X server.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/play.hpp"
#include "app/window/show.hpp"

namespace flipside::app {

struct RenderOptions {
    std::string scene;
    std::string engine = "custom";
    double at = 0;  ///< s
    double dt = 1.0 / 60;
    View view = View::single;
    std::vector<std::string> show;      ///< overlays: boxes, cells, …
    std::vector<std::string> settings;  ///< "ENGINE.NAME=VALUE"
    std::optional<std::filesystem::path> script;
    bool artwork = true;
    unsigned width = 1280, height = 800;  ///< px
};

/// Those that are shown unless something else is asked for, and these: names of show_specs. Throws InputError
/// for any other.
[[nodiscard]] Shows parse_shows(const std::vector<std::string>& names);

/// The bytes of a PNG file.
[[nodiscard]] std::string render(const RenderOptions& options);

}  // namespace flipside::app
