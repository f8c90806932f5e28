#pragma once
/// The control column of the edit mode: the file, undo and redo, what can be drawn, the grid, and the numbers
/// of what is picked.

#include <string>

#include "app/window/controls.hpp"
#include "app/window/editor/editor.hpp"

namespace flipside::app {

class EditorPanel {
  public:
    /// What the user asks for that is not the editor's to do.
    enum class Wish { none, leave, browse, new_scene };

    Wish draw(const Rect& place, Editor& editor, WindowControls& controls, ControlPlaces& places);
    /// The question for a name goes away.
    void reset() { choosing_ = false; }

  private:
    void draw_file(Editor& editor, WindowControls& controls, ControlPlaces& places, Wish& wish);
    void draw_save_as(Editor& editor, WindowControls& controls, ControlPlaces& places);
    void save(Editor& editor, WindowControls& controls);
    void choose_name(const Editor& editor, std::string why);
    void write(Editor& editor, const std::filesystem::path& file, WindowControls& controls);

    bool choosing_ = false;  ///< a name to save under
    bool begins_ = false;    ///< to ask for it: the field gets the keyboard
    std::string typed_;
    std::string why_;  ///< it has to be chosen, in words
};

}  // namespace flipside::app
