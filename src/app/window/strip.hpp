#pragma once
/// The strip of plots below the table.

#include "app/window/canvas.hpp"
#include "app/window/layout.hpp"
#include "app/window/plots.hpp"

namespace flipside::app {

/// `mouse` in pixels of the window.
void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage, PlotChoice choice, Vec2 mouse);

}  // namespace flipside::app
