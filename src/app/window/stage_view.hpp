#pragma once
/// Draws over the table what a stage of a step looked at and did.

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "app/window/microscope.hpp"

namespace flipside::app {

/// All items of the stage thinly, and the picked one boldly; `balls` are as the stage shows them.
void draw_stage_items(Canvas& canvas, const Camera& camera, const TraceStage& stage, std::size_t picked,
                      std::span<const Ball> balls, sf::Color color);

}  // namespace flipside::app
