#pragma once
/// The last half minute as a line below the panes: to drag along, back in time and forth.

#include "app/window/controls.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// Draws it at `place`; where it is dragged, the stage goes there and pauses.
void draw_scrubber(const Rect& place, Stage& stage, WindowControls& controls, ControlPlaces& places);

}  // namespace flipside::app
