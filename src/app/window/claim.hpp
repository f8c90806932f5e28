#pragma once
/// What an engine may still say about its balls, by its own account (World::uncertainty), in radii of the
/// ball.

#include <algorithm>
#include <cmath>

#include "world/world.hpp"

namespace flipside::app {

/// A ball known better than `sure_radii` is drawn in full; beyond `horizon_radii` its trajectory is no longer
/// claimed.
inline constexpr double sure_radii = 1e-9, horizon_radii = 1e-1;

/// 0 for engines that claim nothing of the kind; infinite where the claim has ended. `ball` counts in
/// balls().
[[nodiscard]] inline double uncertainty_in_radii(const World& world, std::size_t ball) {
    return world.uncertainty().empty() ? 0 : world.uncertainty()[ball] / world.balls()[ball].radius;
}

/// 1 where a ball's place is as good as known, falling with the digits to 0 at the horizon.
[[nodiscard]] inline double claim(double uncertainty) {
    if (!(uncertainty < horizon_radii)) return 0;
    return std::min(1.0, std::log10(horizon_radii / std::max(uncertainty, sure_radii)) /
                             std::log10(horizon_radii / sure_radii));
}

}  // namespace flipside::app
