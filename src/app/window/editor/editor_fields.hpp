#pragma once
/// What is picked in the edit mode, as fields to type exact values into.

#include "app/window/controls.hpp"
#include "app/window/editor/editor.hpp"

namespace flipside::app {

/// Name, shape, material, layers and motion; of nothing, the table's own values.
void draw_properties(Editor& editor, ControlPlaces& places);

}  // namespace flipside::app
