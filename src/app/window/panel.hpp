#pragma once
/// The control column: one docked window with tabs.

#include "app/window/controls.hpp"
#include "app/window/lesson_tab.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// Draws the column at `place` and does at once what its controls say. Returns where they are.
ControlPlaces draw_panel(const Rect& place, Stage& stage, WindowControls& controls, Lessons& lessons,
                         const Load& load);

}  // namespace flipside::app
