#pragma once
/// The buttons of what can be drawn, each with a small drawing of it.

#include "lab/editor/palette.hpp"

namespace flipside::app {

/// True when it is pressed.
bool tool_button(const lab::Tool& tool, bool taken, float width);

}  // namespace flipside::app
