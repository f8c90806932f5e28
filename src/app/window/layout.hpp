#pragma once
/// Where everything in the window is, in pixels. Nothing overlaps.

#include <cmath>
#include <vector>

namespace flipside::app {

struct Rect {
    double x = 0, y = 0, width = 0, height = 0;

    [[nodiscard]] bool contains(double px, double py) const {
        return px >= x && px < x + width && py >= y && py < y + height;
    }
    friend bool operator==(const Rect&, const Rect&) = default;
};

struct Layout {
    std::vector<Rect> headers;  ///< one over each pane
    std::vector<Rect> panes;    ///< of equal size
    Rect scrubber;              ///< the line of time, below the panes; no height where there is none
    Rect bar;                   ///< the step bar, below that; no height where there is none
    Rect strip;                 ///< plots, below that; no height where they have no room
    Rect panel;                 ///< the control column; no width where there is none
};

enum class Column { none, folded, open };

struct LayoutNeeds {
    int panes = 1;
    int headers = 1;    ///< one per pane, or several over a single one (overlay)
    double aspect = 1;  ///< width of what the panes show over its height
    Column column = Column::open;
    bool step_bar = false;
    bool scrubber = false;
    double strip = 0;  ///< height of the plots where the user chose one, px on an ordinary display; else 0
};

/// Over a pane, px on an ordinary display: name and score, and below them lines of what the run does.
[[nodiscard]] constexpr double header_height(int lines_of_facts) {
    return 39 + 20 * lines_of_facts;
}
/// In a header of that height.
[[nodiscard]] inline int lines_of_facts(double height) {
    return static_cast<int>(std::lround((height - header_height(0)) / (header_height(1) - header_height(0))));
}

/// In rows and columns so that the table is as large as can be: portrait ones side by side, landscape ones
/// one below the other. `scale` is 1 on an ordinary display. All corners are whole pixels.
[[nodiscard]] Layout lay_out(double width, double height, double scale, const LayoutNeeds& needs);

/// Within what is allowed in a window of that height, px: of a strip that would be `wanted` px high.
[[nodiscard]] double strip_height(double wanted, double height, double scale, bool step_bar);

/// Of letters, lines and controls where the user says nothing: what the display asks for, as far as the
/// window has room for it. 1 on a display of 1080 lines and in a window of 1024 × 640 px.
[[nodiscard]] double usual_scale(double display_lines, double width, double height);
/// The largest that leaves room for the tables beside the open column, whatever the user asks for.
[[nodiscard]] double largest_scale(double width, double height);
inline constexpr double least_scale = 0.75, most_scale = 3, scale_step = 0.25;

}  // namespace flipside::app
