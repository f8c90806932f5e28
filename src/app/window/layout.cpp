#include "app/window/layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipside::app {

namespace {

constexpr double usual_strip = 120, least_strip = 80, bar_height = 216, scrubber_height = 20,
                 least_with_plots = 450, column_width = 332, folded_width = 30, gap = 6;

/// More where the header is narrow, as far as a window of that height has room for them, px on an ordinary
/// display.
int lines_in_header(double width, double height) {
    const int wanted = width < 200 ? 4 : width < 260 ? 3 : width < 430 ? 2 : 1;
    return std::clamp(lines_of_facts(0.2 * height), 1, wanted);
}

double in_steps(double scale) {
    return scale_step * std::floor(scale / scale_step);
}

double column_of(Column column, double scale) {
    if (column == Column::none) return 0;
    return std::round(scale * (column == Column::open ? column_width : folded_width));
}

/// Panes in rows and columns.
struct Grid {
    int columns = 1, rows = 1;
    double width = 0, height = 0;  ///< of a pane, px

    /// What a table of that aspect would be wide in a pane, px.
    [[nodiscard]] double table(double aspect) const { return std::min(width, aspect * height); }
    [[nodiscard]] int cells() const { return columns * rows; }
};

/// Of `count` panes of which each row has a header of `head` px.
Grid grid_of(int columns, int count, double width, double height, double head, double space) {
    Grid grid{columns, (count + columns - 1) / columns};
    grid.width = std::max(1.0, std::floor((width - space * (columns - 1)) / columns));
    grid.height = std::max(1.0, std::floor((height - space * (grid.rows - 1)) / grid.rows) - head);
    return grid;
}

Grid best_grid(int count, double aspect, double width, double height, double head, double space) {
    Grid best = grid_of(count, count, width, height, head, space);
    for (int columns = count - 1; columns >= 1; --columns) {
        const Grid other = grid_of(columns, count, width, height, head, space);
        const double gain = other.table(aspect) - best.table(aspect);
        if (gain > 0 || (gain == 0 && other.cells() < best.cells())) best = other;
    }
    return best;
}

}  // namespace

Layout lay_out(double width, double height, double scale, const LayoutNeeds& needs) {
    Layout layout;
    const double space = std::round(scale * gap);
    const double panel = std::min(column_of(needs.column, scale), width);
    layout.panel = {width - panel, 0, panel, height};

    // On a small display the table keeps most of the height. Where the step bar has no room for its items,
    // the plots make way for it.
    const bool low = needs.step_bar && height < scale * least_with_plots;
    const double strip = low               ? 0
                         : needs.strip > 0 ? strip_height(scale * needs.strip, height, scale, needs.step_bar)
                                           : std::round(std::min(scale * usual_strip, 0.18 * height));
    const double room = std::max(1.0, width - panel - (panel > 0 ? space : 0));
    const double bar =
        needs.step_bar ? std::round(std::min(scale * bar_height, (low ? 0.42 : 0.3) * height)) : 0;
    const double scrubber = needs.scrubber ? std::round(scale * scrubber_height) : 0;
    const double below = (needs.scrubber ? scrubber + space : 0) + (needs.step_bar ? bar + space : 0) +
                         (low ? 0 : strip + space);
    const double tables = std::max(1.0, height - below - space);
    const double each = std::max(1.0, std::floor((room - space * (needs.headers - 1)) / needs.headers));
    const auto head_of = [&](double of_width) {
        return std::round(scale * header_height(lines_in_header(of_width / scale, height / scale)));
    };
    double head = head_of(needs.panes == needs.headers ? room : each);
    Grid grid = best_grid(needs.panes, needs.aspect, room, tables, head, space);
    if (needs.panes == needs.headers && head_of(grid.width) > head) {
        head = head_of(grid.width);
        grid = grid_of(grid.columns, needs.panes, room, tables, head, space);
    }
    for (int i = 0; i < needs.panes; ++i) {
        const double x = i % grid.columns * (grid.width + space);
        const double y = std::floor(i / grid.columns) * (head + grid.height + space);
        layout.panes.push_back({x, y + head, grid.width, grid.height});
    }
    for (int i = 0; i < needs.headers; ++i) {
        if (needs.panes == needs.headers) {
            const Rect& pane = layout.panes[static_cast<std::size_t>(i)];
            layout.headers.push_back({pane.x, pane.y - head, pane.width, head});
        } else {
            layout.headers.push_back({i * (each + space), 0, each, head});
        }
    }
    double y = tables + space;
    for (const auto& [rect, h] :
         {std::pair(&layout.scrubber, scrubber), {&layout.bar, bar}, {&layout.strip, strip}}) {
        *rect = {0, y, room, h};
        if (h > 0) y += h + space;
    }
    return layout;
}

double strip_height(double wanted, double height, double scale, bool step_bar) {
    const double most = (step_bar ? 0.22 : 0.45) * height;
    return std::round(std::clamp(wanted, std::min(scale * least_strip, most), most));
}

double usual_scale(double display_lines, double width, double height) {
    const double display = std::max(1.0, in_steps(display_lines / 1080));
    return std::clamp(in_steps(std::min({display, width / 1024, height / 640})), least_scale, most_scale);
}

double largest_scale(double width, double height) {
    return std::clamp(in_steps(std::min(width / 640, height / 360)), least_scale, most_scale);
}

}  // namespace flipside::app
