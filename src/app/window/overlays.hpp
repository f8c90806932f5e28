#pragma once
/// What can be switched on over the table: what the run left behind, what the scene's geometry says, and
/// what the engine draws of its insides. Line widths are in pixels.

#include "app/window/table_view.hpp"

namespace flipside::app {

/// Below the balls.
void draw_overlays(Canvas& canvas, const Camera& camera, const Run& run, const Look& look);
/// Above the balls.
void draw_marks(Canvas& canvas, const Camera& camera, const Run& run, const Look& look);

}  // namespace flipside::app
