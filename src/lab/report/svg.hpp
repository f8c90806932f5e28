#pragma once
/// Makes gnuplot's SVG fit into a page: ids of its own, the page's colour for what is black, and points that
/// tell what they are.

#include <span>
#include <string>

#include "lab/report/figure.hpp"

namespace flipside::lab::report {

/// gnuplot draws in this colour what has no colour of its own: text, axes. In a page it is the text's.
inline constexpr std::string_view ink = "#010101";

/// The figure's id as gnuplot takes it for names in an SVG file: letters, digits, underscores.
[[nodiscard]] std::string svg_name(const Figure& figure);

/// What a point says when it is pointed at: series, setting, coordinates; several lines.
[[nodiscard]] std::string words_of(const Figure& figure, const Series& series, const Point& point);

/// `svg` as gnuplot wrote it for the figure. Each point becomes <g class="point"><title>its words</title>…;
/// no scripts and nothing from elsewhere are asked for any more. `elements` says of which series each element
/// of the plot is; it becomes a group of that series' class (html.hpp).
[[nodiscard]] std::string inline_svg(const std::string& svg, const Figure& figure,
                                     std::span<const std::size_t> elements);

}  // namespace flipside::lab::report
