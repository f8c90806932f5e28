#pragma once
/// The window.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace flipside::app {

enum class View { single, split, overlay };

struct PlayOptions {
    std::string scene = "pinball";
    std::string engine = "custom";  ///< the one that is shown in the single view
    View view = View::split;
    std::vector<std::string> contenders;  ///< "NAME=ENGINE[,dt=H][,K=V]..."; none: the engines as they are
    std::optional<double> dt;             ///< s; nothing: the scene's
    std::vector<std::string> settings;    ///< "ENGINE.NAME=VALUE"
    std::optional<std::filesystem::path> script;  ///< played from the start
    std::optional<std::filesystem::path> lesson;  ///< opened instead of the scene
    std::optional<std::filesystem::path> report;  ///< where to write the window's state as JSON lines
    std::filesystem::path screenshots = ".";      ///< where F12 puts them
    unsigned width = 1280, height = 800;          ///< px
};

/// Runs the window until it is closed. Throws InputError for bad input; returns the exit code.
int play(const PlayOptions& options);

}  // namespace flipside::app
