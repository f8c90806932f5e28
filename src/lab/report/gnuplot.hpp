#pragma once
/// Draws figures with gnuplot (T. Williams, C. Kelley and others): SVG for the page, PNG for everything else.

#include <filesystem>
#include <string>

#include "lab/report/figure.hpp"

namespace flipside::lab::report {

/// The picture and the box of the axes in it, px from the upper left corner. The key stands at the right.
inline constexpr double picture_width = 900, picture_height = 460;
inline constexpr double box_left = 90, box_right = 590, box_top = 20, box_bottom = 390;

/// A gnuplot script, to be run in the folder that it is in, that reads `csv` and writes ID.svg and ID.png, or
/// what its variables `svg` and `png` say.
/// In the SVG every point is a group whose hypertext is the number of its row, from 0.
[[nodiscard]] std::string script_of(const Figure& figure, const std::string& csv);

/// Writes ID.gp, ID.svg and ID.png into `pictures`; the figure's CSV file must be there. Returns the SVG's
/// text as it stands in a page, see svg.hpp. Throws Failure when gnuplot does not, or for an id that is no
/// plain name.
std::string draw(const Figure& figure, const std::filesystem::path& csv,
                 const std::filesystem::path& pictures);

/// "gnuplot 5.4 patchlevel 4". Throws Failure, with what to install, where there is no gnuplot.
[[nodiscard]] std::string gnuplot_version();

}  // namespace flipside::lab::report
