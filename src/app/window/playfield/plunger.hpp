#pragma once
/// The plunger behind a ball that waits to be fired.

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "world/scene.hpp"

namespace flipside::app {

/// Pulled back as far as the launch is charged, 0…1.
void draw_plunger(Canvas& canvas, const Camera& camera, const Launcher& launcher, double charge);

}  // namespace flipside::app
