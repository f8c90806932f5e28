#pragma once
/// Active kickers as they look on a table: bumpers under a cap that says what they score, slingshots as a
/// band between two posts.

#include <string>

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "world/shape.hpp"

namespace flipside::app {

/// `light` is 1 right after a hit and falls to 0; `points` are written where there is room, or "".
void draw_bumper(Canvas& canvas, const Camera& camera, const shape::Circle& bumper, double light,
                 const std::string& points);
void draw_band(Canvas& canvas, const Camera& camera, const shape::Segment& band, double light);

}  // namespace flipside::app
