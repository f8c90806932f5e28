#pragma once
/// What was wrong with an impact, by the account of the exact engine.

#include <optional>

#include "lab/impact_log.hpp"

namespace flipside::lab {

/// How an impact differs from the exact one of the same pair.
struct ImpactError {
    double late = 0;      ///< s; below 0: early
    double normal = 0;    ///< rad between the two normals, 0 to π
    double distance = 0;  ///< m between the two points
    double speed = 0;     ///< m/s by which it approached faster
};
[[nodiscard]] ImpactError error_of(const Event& impact, const Event& exact);

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
