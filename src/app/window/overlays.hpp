#pragma once
/// What can be switched on over the table: what the run left behind, what the scene's geometry says, and
/// what the engine draws of its insides. Line widths are in pixels.

#include "app/window/table_view.hpp"

namespace flipside::app {

/// Below the balls.
void draw_overlays(Canvas& canvas, const Camera& camera, const Run& run, const Look& look);
/// Above the balls. `alone`: no other run is on this table; else the engine shows its insides in its colour.
void draw_marks(Canvas& canvas, const Camera& camera, const Run& run, const Look& look, bool alone);

}  // namespace flipside::app
