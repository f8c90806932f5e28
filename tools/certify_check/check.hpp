#pragma once
/// What has to hold of a run, piece by piece.

#include <map>
#include <stdexcept>

#include "surface.hpp"

namespace certificate {

/// The first condition that does not hold.
struct Rejected : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Verdict {
    std::size_t balls = 0, legs = 0, impacts = 0, given = 0, held = 0, comparisons = 0;
    std::size_t not_isolated = 0;           ///< impacts without an interval: grazes
    double let_through = 0;                 ///< ball-seconds in gates, which nothing is checked of
    std::map<std::string, double> largest;  ///< by condition: the largest share of the bound that was taken
};

/// `bound` is relative: lengths to the ball's radius, speeds to |v| + r|spin| + √(r|g|), accelerations to
/// |g| + (that speed)²/r. Throws Rejected.
[[nodiscard]] Verdict check(const Run& run, double bound);

}  // namespace certificate
