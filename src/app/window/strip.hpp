#pragma once
/// The strip of plots below the table.

#include "app/window/canvas.hpp"
#include "app/window/controls.hpp"
#include "app/window/layout.hpp"
#include "app/window/plots.hpp"

namespace flipside::app {

/// The edge above the strip, which is dragged to make it higher or lower; a double click makes it as it was.
void drag_strip(const Layout& layout, double scale, WindowControls& controls, ControlPlaces& places);

/// `mouse` in pixels of the window.
void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage, PlotChoice choice, Vec2 mouse);

}  // namespace flipside::app
