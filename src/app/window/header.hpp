#pragma once
/// The header over a pane: engine, solver, cost per step, energy, balls; score and balls left.

#include <optional>

#include "app/window/canvas.hpp"
#include "app/window/layout.hpp"
#include "app/window/run.hpp"

namespace flipside::app {

/// `score` is the one to show, which may still be counting up; the cost is that of a step or, so that
/// it can be compared with that of other steps, of a simulated second. `pace` is there where this run keeps
/// the table slower than it should be: simulated seconds per second. Returns where its step stands, which is
/// to be clicked; nothing where there is no room for it.
[[nodiscard]] std::optional<Rect> draw_header(Canvas& canvas, const Rect& place, const Run& run, long score,
                                              bool per_second, std::optional<double> pace);

}  // namespace flipside::app
