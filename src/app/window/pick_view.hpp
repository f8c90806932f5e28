#pragma once
/// Draws what the mouse has picked and does: a ring around the ball, the line of a sling.

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "app/window/table_view.hpp"

namespace flipside::app {

/// Over the balls of a run. (A part that is picked is drawn bright with the table.)
void draw_picked(Canvas& canvas, const Camera& camera, std::span<const Ball> balls, const Look& look);

}  // namespace flipside::app
