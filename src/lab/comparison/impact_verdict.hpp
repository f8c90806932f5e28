#pragma once
/// Whether the last impact of a ball or part agrees with the exact engine.

#include <optional>

#include "lab/comparison/impact_error.hpp"
#include "lab/comparison/impact_log.hpp"

namespace flipside::lab {

struct ImpactVerdict {
    Event impact;  ///< the contender's; the exact one where it is missed
    bool missed = false;
    std::optional<ImpactError> error;  ///< nothing where one of the two has no such impact
};

/// Of the last impact of a ball or part until `now`. Impacts of the same pair that are at most `tolerance` s
/// apart are the same; one that is younger than that, and may find its match yet, is passed over in favour
/// of none. Nothing where there is none to judge. Beyond `certain`, s, nothing is exact and nothing is
/// judged.
[[nodiscard]] std::optional<ImpactVerdict> judge(const ImpactLog& contender, const ImpactLog& exact,
                                                 Other subject, double tolerance, double now, double certain);

}  // namespace flipside::lab
