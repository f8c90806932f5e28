#include "lab/comparison/impact_error.hpp"

#include <cmath>

#include "world/math.hpp"

namespace flipside::lab {

ImpactError error_of(const Event& impact, const Event& exact) {
    const double turn = math::atan2(cross(exact.normal, impact.normal), dot(exact.normal, impact.normal));
    return {impact.time - exact.time, std::abs(turn), length(impact.point - exact.point),
            impact.speed - exact.speed};
}

}  // namespace flipside::lab
