#pragma once
/// The window's state as JSON lines, so that a test can see what happened: one object a frame.

#include <filesystem>
#include <fstream>
#include <string>

#include "app/window/card.hpp"
#include "app/window/controls.hpp"
#include "app/window/game_end.hpp"
#include "app/window/lesson_tab.hpp"
#include "app/window/microscope.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// What the report says beside the stage itself.
struct WindowState {
    unsigned long frame = 0;
    double width = 0, height = 0;  ///< px
    std::string last_key;          ///< name of the last action a key asked for, with "+" down or "-" up
    std::string last_screenshot;
    std::string last_export;  ///< the CSV
    std::string last_game;    ///< the replay
    double charge = 0;
    std::string slow;            ///< as in Readings
    std::string edit;            ///< what is drawn, as JSON; "" outside the edit mode
    bool browser = false;        ///< all scenes are on show
    std::optional<Card> card;    ///< while one is open
    std::optional<GameEnd> end;  ///< of the game on show, once it is over
};

class WindowReport {
  public:
    /// Throws std::runtime_error when the file cannot be written.
    explicit WindowReport(const std::filesystem::path& file);

    void write(const Stage& stage, const Microscope& microscope, const Lessons& lessons,
               const WindowState& window, const WindowControls& controls, const Layout& layout,
               const Camera& camera, const ControlPlaces& places);

  private:
    std::ofstream out_;
};

}  // namespace flipside::app
