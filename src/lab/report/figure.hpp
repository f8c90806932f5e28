#pragma once
/// A figure as plain data: axes, series of points, marks. It knows no drawing program; gnuplot.hpp draws it.

#include <filesystem>
#include <string>
#include <vector>

namespace flipside::lab::report {

/// Colour-blind safe (M. Okabe and K. Ito, Color Universal Design, 2008; P. Tol, Colour Schemes, 2021);
/// engines have theirs for good.
namespace colour {
inline constexpr std::string_view custom = "#56b4e9", box2d = "#e69f00", reference = "#009e73",
                                  warning = "#d55e00", violet = "#cc79a7", blue = "#0072b2", grey = "#808080",
                                  olive = "#999933", wine = "#882255";
}

struct Point {
    double x = 0;
    double y = 0;      ///< infinite where the run failed: marked with a cross at the upper edge
    std::string says;  ///< the setting and what else hovering tells; of a failed run the reason
};

/// Shown by colour, dashes and shape of its points, so that colours are not needed to tell it.
struct Series {
    std::string name;
    std::string colour;
    int dash = 1;  ///< gnuplot's dash type: 1 solid, 2 … 5 dashed
    int marker =
        7;  ///< gnuplot's point type: 5 square, 7 disc, 9 triangle, 11 turned, 13 lozenge; 4 … hollow
    double size = 0.8;   ///< of the points
    bool joined = true;  ///< by a line, in their order
    std::vector<Point> points;
    bool shown = true;  ///< in the page at once; else when its name is ticked
};

struct Axis {
    std::string label;
    std::string column;  ///< its name in the CSV file
    bool logarithmic = false;
    /// What lies below is drawn at the lower edge of the figure; so a logarithm can show 0. 0: no floor.
    double floor = 0;
    /// What is at 1, 2, 3 ... where the axis has no numbers, but things: "rain", "gas".
    std::vector<std::string> things{};
};

/// A line across the figure at one x.
struct Mark {
    double x = 0;
    std::string says;
    std::string colour;
    bool shaded = false;  ///< so is all that lies to the right of it
};

struct Figure {
    std::string id;  ///< of its files and of its place in the page; a plain name (plain_name.hpp)
    std::string title;
    Axis x, y;
    std::vector<Series> series;
    std::vector<Mark> marks;
    std::string reading;    ///< two sentences on how to read it
    bool on_front = false;  ///< it stands on the front page and not in its chapter
};

struct Range {
    double from, to;
};
/// What the axes show: all points that did not fail, to whole decades or round numbers, and a little more, so
/// that no point lies on the border.
struct Frame {
    Range x, y;
};
[[nodiscard]] Frame frame_of(const Figure& figure);

/// All points in the order of the CSV's rows: by series, those of failed runs last in each.
[[nodiscard]] std::vector<std::pair<const Series*, const Point*>> rows_of(const Figure& figure);
/// A row and a line per point: series, x and y under the axes' names, point (what it says, lines joined by ";
/// ").
void write_csv(const Figure& figure, const std::filesystem::path& file);

/// A number for people: 4 significant digits.
[[nodiscard]] std::string short_number(double value);
/// With so many significant digits, and thousands set apart: "0.052", "1,250".
[[nodiscard]] std::string rounded_text(double value, int digits = 2);
/// A step size as "1/60 s".
[[nodiscard]] std::string step_text(double dt);
/// Seconds with the unit that suits them: "26 µs", "1.3 ms", "4.1 s".
[[nodiscard]] std::string time_text(double seconds);
/// A ratio as "4.1 times"; with 2 significant digits.
[[nodiscard]] std::string times_text(double ratio);

}  // namespace flipside::lab::report
