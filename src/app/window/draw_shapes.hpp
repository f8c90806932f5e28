#pragma once
/// Draws the shape of a part, wherever it has turned to.

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "world/shape.hpp"
#include "world/table.hpp"

namespace flipside::app {

struct ShapeStyle {
    sf::Color line;
    sf::Color fill;    ///< of solid shapes
    double width = 1;  ///< of lines, px
    double glow = 0;   ///< 0…1, of a light inside
};

void draw_shape(Canvas& canvas, const Camera& camera, const Shape& shape, const Pose& pose,
                const ShapeStyle& style);

}  // namespace flipside::app
