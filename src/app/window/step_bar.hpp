#pragma once
/// The step bar: the stages of the step that is looked into, the current one with its sentence, its items as
/// a list, and the picked one with the formula that it used.

#include "app/window/controls.hpp"
#include "app/window/microscope.hpp"

namespace flipside::app {

/// Draws it at `place` and does at once what its controls say; notes where they are.
void draw_step_bar(const Rect& place, Stage& stage, Microscope& microscope, ControlPlaces& places);

/// An item in one line, without its formula.
[[nodiscard]] std::string in_one_line(const TraceItem& item);

}  // namespace flipside::app
