#pragma once
/// What makes a hit and a fast ball felt: sparks and a soft trail. Both are a function of what the run left
/// behind and its time, so going back, slow motion and pictures have the same ones.

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "app/window/run.hpp"

namespace flipside::app {

/// Sparks of the last hits that were hard: an approach that crosses a sixth of the pane in a second at least.
void draw_sparks(Canvas& canvas, const Camera& camera, const Run& run);
/// The last tenth of a second of the way of each ball: the faster, the longer. Nothing among more than
/// `most_trails` balls: there trails hide more than they show.
void draw_trails(Canvas& canvas, const Camera& camera, const Run& run, std::span<const Ball> balls);
inline constexpr std::size_t most_trails = 40;

}  // namespace flipside::app
