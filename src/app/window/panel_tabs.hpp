#pragma once
/// The tabs of the control column but for the lessons'.

#include "app/window/panel_parts.hpp"

namespace flipside::app {

/// Scene, time, balls.
void draw_table_tab(const Panel& panel);
/// What is drawn on the table, and what it means; the size of letters.
void draw_see_tab(const Panel& panel);
/// View, reference, and each contender's engine, step and settings, made from their descriptions. What an
/// engine refuses becomes the notice.
void draw_engines_tab(const Panel& panel);
/// Balls in play, tests and hits, broad phase: one column per run.
void draw_numbers_tab(const Panel& panel, const Load& load);

}  // namespace flipside::app
