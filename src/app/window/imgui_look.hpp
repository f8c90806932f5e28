#pragma once
/// Style and fonts of Dear ImGui, as the rest of the window has them.

namespace flipside::app {

/// At another scale than before too. Throws std::runtime_error when there are no fonts.
void set_imgui_look(double scale);

}  // namespace flipside::app
