#pragma once
/// What the edit mode draws over the table: handles, the figure that is begun, where it snaps to, and what is
/// wrong.

#include "app/window/canvas.hpp"
#include "app/window/editor/editor.hpp"

namespace flipside::app {

void draw_marks(Canvas& canvas, const Editor& editor, const Camera& camera);

}  // namespace flipside::app
