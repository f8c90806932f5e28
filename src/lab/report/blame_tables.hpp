#pragma once
/// A sweep's blame as tables.

#include <vector>

#include "lab/report/best_settings.hpp"
#include "lab/report/page.hpp"
#include "lab/sweep/summary.hpp"

namespace flipside::lab::report {

/// One table per variant, in the order of the figures: where the divergences of each contender begin, by
/// fault and kind of part, over all its steps, and a sentence on each that is telling (best_settings.hpp). A
/// contender that never diverged has a row that says so.
[[nodiscard]] std::vector<Table> blame_tables(const std::vector<sweep::Figures>& all,
                                              std::span<const Best> best);

}  // namespace flipside::lab::report
