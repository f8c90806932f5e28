#include "app/window/strip.hpp"

#include <cmath>

namespace flipside::app {

void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage, PlotChoice choice, Vec2 mouse) {
    const std::vector<Plot> plots = plots_of(choice, stage);
    const PlotTime time{stage.time(), 2.5 * stage.dt(), mouse};
    const double gap = canvas.scaled(6), count = static_cast<double>(plots.size());
    const double width = std::floor((place.width - (count - 1) * gap) / count);
    for (std::size_t i = 0; i < plots.size(); ++i)
        draw_plot(canvas, {place.x + static_cast<double>(i) * (width + gap), place.y, width, place.height},
                  plots[i], time);
}

}  // namespace flipside::app
