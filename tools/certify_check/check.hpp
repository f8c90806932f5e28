#pragma once
/// What has to hold of a run, segment by segment: how it begins, how it moves, and that nothing came earlier.

#include <functional>
#include <map>
#include <stdexcept>

#include "surface.hpp"

namespace certificate {

/// The first condition that does not hold.
struct Rejected : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Verdict {
    std::size_t balls = 0, legs = 0, held = 0, impacts = 0, enclosures = 0;
    std::size_t touches = 0;                ///< without approach: they change nothing
    std::size_t not_isolated = 0;           ///< impacts without an isolating interval
    std::size_t given = 0;                  ///< segments that begin by the start or an input
    std::size_t resting = 0;                ///< segments at rest, held by forces that are stated
    double loosest = 0;                     ///< the largest gap or overlap of these, in radii
    std::map<std::string, double> largest;  ///< by condition: the largest share of the bound that was taken
};

/// `bound` is relative: lengths to the ball's radius r, speeds to √(r|g|) + |v| + r|spin|, accelerations to
/// |g| + that speed squared over r. Throws Rejected; another exception where the file is no certificate.
[[nodiscard]] Verdict check(Run& run, double bound);

}  // namespace certificate
