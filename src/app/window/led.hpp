#pragma once
/// A number in seven-segment figures, unlit segments faintly visible, as on a score display.

#include "app/window/canvas.hpp"

namespace flipside::app {

/// Width of `digits` figures of that height, px.
[[nodiscard]] double led_width(int digits, double height);
/// `at` is the top left. Leading zeros stay dark. A number too large for the figures shows its last ones.
void draw_led(Canvas& canvas, Vec2 at, double height, int digits, long number, sf::Color color);

}  // namespace flipside::app
