#pragma once
/// The strip below the table: how far the two runs are apart, and energy over time.

#include "app/window/canvas.hpp"
#include "app/window/layout.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage);

}  // namespace flipside::app
