#pragma once
/// The window.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace flipside::app {

enum class View { single, split, overlay };

[[nodiscard]] constexpr const char* view_name(View view) {
    return view == View::single ? "single" : view == View::split ? "split" : "overlay";
}

/// Nothing: as it was kept of the last start, or else as Kept has it.
struct PlayOptions {
    std::optional<std::string> scene;
    std::string engine;                   ///< the one that is shown in the single view; "": custom
    std::optional<View> view;             ///< split
    std::vector<std::string> contenders;  ///< "NAME=ENGINE[,dt=H][,K=V]..."; none: the engines as they are
    std::optional<double> dt;             ///< s; nothing: the scene's
    std::vector<std::string> settings;    ///< "ENGINE.NAME=VALUE"
    std::optional<std::filesystem::path> script;  ///< played from the start
    std::optional<std::filesystem::path> lesson;  ///< opened instead of the scene
    std::optional<std::filesystem::path> report;  ///< where to write the window's state as JSON lines
    std::filesystem::path screenshots = ".";      ///< where F12 puts them
    std::optional<unsigned> width, height;        ///< px
    std::optional<double> scale;                  ///< of letters and controls
    bool keep = true;  ///< begins with what was kept of the last start, where nothing is said; and keeps
};

/// Runs the window until it is closed. Throws InputError for bad input; returns the exit code.
int play(const PlayOptions& options);

}  // namespace flipside::app
