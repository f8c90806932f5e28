#pragma once
/// The report: measures what its chapters need, draws their figures and writes the page.
///
///     DIR/data/            what was measured, a file per measurement; figure-ID.csv: the points of each
///     figure DIR/figures/         ID.svg, ID.png and the gnuplot script ID.gp that drew them DIR/index.html
///     the page, which needs none of the others

#include <filesystem>
#include <string>

#include "lab/report/chapter.hpp"

namespace flipside::lab::report {

struct ReportInput {
    std::filesystem::path out;
    std::vector<std::filesystem::path> from;  ///< folders of one sweep, to be shown instead of measuring one
    Effort effort;
    bool redraw = false;  ///< from what is in `out`, whatever build measured it; nothing is measured
};

/// A chapter whose data are missing is left out of a redrawn one, and the notice says so.
/// A report that was stopped goes on where it was; `notice` is told of data that are damaged and measured
/// again. Throws Failure when gnuplot is missing, and InputError when `out` holds the data of another effort
/// or build (they would not say what the page says they do), and for a folder of `from` that is damaged.
void make_report(const ReportInput& input, const Watch& watch, const Notice& notice);

}  // namespace flipside::lab::report
