#pragma once
/// Every key and what it does.

#include "app/window/controls.hpp"

namespace flipside::app {

/// In the middle of `place`. Notes where each line is, as "help: KEYS".
void draw_help(const Rect& place, ControlPlaces& places);

}  // namespace flipside::app
