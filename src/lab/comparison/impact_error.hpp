#pragma once
/// What was wrong with an impact, by the account of the exact engine.

#include "world/events.hpp"

namespace flipside::lab {

/// How an impact differs from the exact one of the same pair.
struct ImpactError {
    double late = 0;      ///< s; below 0: early
    double normal = 0;    ///< rad between the two normals, 0 to π
    double distance = 0;  ///< m between the two points
    double speed = 0;     ///< m/s by which it approached faster
};
[[nodiscard]] ImpactError error_of(const Event& impact, const Event& exact);

}  // namespace flipside::lab
