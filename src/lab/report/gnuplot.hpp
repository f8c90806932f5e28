#pragma once
/// Draws figures with gnuplot (T. Williams, C. Kelley and others): SVG for the page, PNG for everything else.

#include <filesystem>
#include <string>

#include "lab/report/figure.hpp"

namespace flipside::lab::report {

/// A picture and the box of the axes in it, px from the upper left corner.
struct Layout {
    double width, height;
    double left, right, top, bottom;
    bool has_words;  ///< names of the axes, and the key at the right; a page has them in its own text
};
/// As files, and as it stands in a page, which may show it on a phone: few px, so that its letters stay
/// large.
[[nodiscard]] Layout file_layout(const Figure& figure);
[[nodiscard]] Layout page_layout(const Figure& figure);

/// A gnuplot script, to be run in the folder that it is in, that reads `csv` and writes ID.svg and ID.png, or
/// what its variables `svg` and `png` say, and the picture for the page where the variable `page` does.
/// In an SVG every point is a group whose hypertext is the number of its row, from 0.
[[nodiscard]] std::string script_of(const Figure& figure, const std::string& csv);

/// Writes ID.gp, ID.svg and ID.png into `pictures`; the figure's CSV file must be there. Returns the SVG's
/// text as it stands in a page, see svg.hpp. Throws Failure when gnuplot does not, or for an id that is no
/// plain name. The text is that of the picture for the page.
std::string draw(const Figure& figure, const std::filesystem::path& csv,
                 const std::filesystem::path& pictures);

/// "gnuplot 5.4 patchlevel 4". Throws Failure, with what to install, where there is no gnuplot.
[[nodiscard]] std::string gnuplot_version();

}  // namespace flipside::lab::report
