#include "app/window/layout.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::app {

namespace {

constexpr double header_height = 62, strip_height = 104, bar_height = 216, column_width = 316,
                 folded_width = 30, gap = 6;

double column_of(Column column, double scale) {
    if (column == Column::none) return 0;
    return std::round(scale * (column == Column::open ? column_width : folded_width));
}

}  // namespace

Layout lay_out(double width, double height, double scale, int panes, int headers, Column column,
               bool step_bar) {
    Layout layout;
    const double space = std::round(scale * gap);
    const double panel = std::min(column_of(column, scale), width);
    layout.panel = {width - panel, 0, panel, height};

    const double head = std::round(scale * header_height);
    // On a small display the table keeps most of the height.
    const double strip = std::round(std::min(scale * strip_height, 0.18 * height));
    const double room = std::max(1.0, width - panel - (panel > 0 ? space : 0));
    const double bar = step_bar ? std::round(std::min(scale * bar_height, 0.3 * height)) : 0;
    const double below = strip + space + (step_bar ? bar + space : 0);
    const double pane_height = std::max(1.0, height - head - below - space);
    const auto column_at = [&](int index, int count, double y, double h) {
        const double each = std::floor(std::max(1.0, room - space * (count - 1)) / count);
        return Rect{index * (each + space), y, each, h};
    };
    for (int i = 0; i < headers; ++i) layout.headers.push_back(column_at(i, headers, 0, head));
    for (int i = 0; i < panes; ++i) layout.panes.push_back(column_at(i, panes, head, pane_height));
    layout.bar = {0, head + pane_height + space, room, bar};
    layout.strip = {0, head + pane_height + space + (step_bar ? bar + space : 0), room, strip};
    return layout;
}

}  // namespace flipside::app
