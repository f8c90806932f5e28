#include "lab/report/svg.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lab/process/failure.hpp"
#include "lab/report/html.hpp"
#include "lab/report/markup.hpp"

namespace flipside::lab::report {

namespace {

void replace_all(std::string& text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

/// From `begin` to the end of the next `end`.
void erase_through(std::string& text, std::string_view begin, std::string_view end) {
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        const std::size_t stop = text.find(end, at);
        if (stop == std::string::npos) throw Failure("gnuplot wrote an SVG file without an end");
        text.erase(at, stop + end.size() - at);
    }
}

/// gnuplot's hypertext, which is the number of the row, becomes the words of that row.
std::string with_words(const std::string& svg, const Figure& figure) {
    constexpr std::string_view begin = "<g onmousemove=\"gnuplot_svg.showHypertext(evt,'";
    constexpr std::string_view end = "<title> </title>";
    const auto rows = rows_of(figure);
    std::string out;
    std::size_t done = 0;
    for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, done)) {
        std::size_t row = 0;
        std::from_chars(svg.data() + at + begin.size(), svg.data() + svg.size(), row);
        const std::size_t stop = svg.find(end, at);
        if (stop == std::string::npos || row >= rows.size())
            throw Failure("gnuplot wrote an SVG file with points that were not asked for");
        const auto& [series, point] = rows[row];
        out.append(svg, done, at - done);
        out += "<g class=\"point\"><title>" + escape(words_of(figure, *series, *point)) + "</title>";
        done = stop + end.size();
    }
    return out.append(svg, done);
}

/// gnuplot numbers the elements of a plot from 1; each becomes one of its series' class.
void name_series(std::string& svg, const Figure& figure, std::span<const std::size_t> elements) {
    for (std::size_t i = 0; i < elements.size(); ++i)
        replace_all(svg, "id=\"" + svg_name(figure) + "_plot_" + std::to_string(i + 1) + "\"",
                    "class=\"" + series_class(elements[i]) + "\"");
}

}  // namespace

std::string svg_name(const Figure& figure) {
    std::string name = figure.id;
    for (char& c : name)
        if (c == '-' || c == '.') c = '_';
    return name;
}

std::string words_of(const Figure& figure, const Series& series, const Point& point) {
    std::string words = series.name;
    if (!point.says.empty()) words += "\n" + point.says;
    if (std::isfinite(point.x)) words += "\n" + figure.x.label + ": " + short_number(point.x);
    if (std::isfinite(point.y)) words += "\n" + figure.y.label + ": " + short_number(point.y);
    return words;
}

std::string inline_svg(const std::string& svg, const Figure& figure, std::span<const std::size_t> elements) {
    std::string text = with_words(svg, figure);
    erase_through(text, "<?xml", "?>\n");
    erase_through(text, "<desc>", "</desc>\n");
    name_series(text, figure, elements);
    erase_through(text, "<title>" + svg_name(figure), "</title>");  // names of plots, of no use to anybody
    replace_all(text, "rgb(  1,   1,   1)", "currentColor");
    replace_all(text, "rgb(1,1,1)", "currentColor");
    replace_all(text, "color=\"black\" ", "");
    replace_all(text, "gpPt", figure.id + "-pt");
    replace_all(text, "id='gpDot'", "id='" + figure.id + "-dot'");
    replace_all(text, "id=\"gnuplot_canvas\"", "");
    erase_through(text, "<filter id='textbox'", "</filter>\n");
    erase_through(text, "<filter id='greybox'", "</filter>\n");
    replace_all(text, "<svg \n width=\"",
                "<svg role=\"img\" aria-label=\"" + escape(figure.title) + "\"\n width=\"");
    return text;
}

}  // namespace flipside::lab::report
