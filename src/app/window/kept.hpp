#pragma once
/// What the window keeps between starts, in one JSON file of the form of assets/window.schema.json.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/play.hpp"
#include "app/window/plots.hpp"
#include "app/window/table_view.hpp"

namespace flipside::app {

struct Kept {
    unsigned width = 1280, height = 800;  ///< px
    double scale = 0;                     ///< of letters and controls; 0: as suits the window
    std::string scene = "pinball";        ///< a name, or the absolute path of a file
    std::string lesson;                   ///< its name, where one is open instead
    View view = View::split;
    std::vector<std::string> contenders;  ///< as in PlayOptions
    Look look;
    bool panel_open = true;
    PlotChoice plots = PlotChoice::distance_and_energy;
    double strip = 0;  ///< height of the plots, as in LayoutNeeds
    bool muted = false;

    friend bool operator==(const Kept&, const Kept&) = default;
};

/// flipside/window.json in $XDG_STATE_HOME or else in ~/.local/state (XDG Base Directory Specification 0.8:
/// state, for it is what was on show). Nothing where there is no such folder to be named.
[[nodiscard]] std::optional<std::filesystem::path> kept_file();
/// Throws InputError where it cannot be read or is of another form.
[[nodiscard]] Kept load_kept(const std::filesystem::path& file);

/// A scene by what finds it again at another start: its name, or the absolute path of its file.
[[nodiscard]] std::string kept_name(const std::string& scene);

/// Writes what is kept when it has changed, but not what somebody else put there.
class Keeper {
  public:
    /// A start without such a file is the first one.
    explicit Keeper(std::filesystem::path file);

    [[nodiscard]] bool first_start() const { return first_start_; }
    /// What the file held, or nothing.
    [[nodiscard]] const std::optional<Kept>& found() const { return found_; }
    /// Once a file cannot be written it is left alone. Returns what is wrong the first time, "" otherwise.
    [[nodiscard]] std::string keep(const Kept& kept);
    /// What was wrong with the file at the start; "" if nothing.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

  private:
    std::filesystem::path file_;
    bool first_start_ = false;
    bool writable_ = true;
    std::optional<Kept> found_, last_;
    std::string trouble_;
};

}  // namespace flipside::app
