#pragma once
/// The regimes in which speed is measured: what a step costs depends on what the balls do.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "world/scene.hpp"

namespace flipside::bench {

struct Regime {
    std::string name;
    int balls = 0;
    /// One scene, or several of which the mean counts.
    std::function<std::vector<std::shared_ptr<const Scene>>()> scenes;
    double from = 0, seconds = 0;  ///< of simulated time: what counts
    bool bare = true;              ///< the bare loop knows its shapes
    bool keeps_energy = false;     ///< nothing is inelastic
};

/// Gas, rain that falls, heaps up and lies in heaps, sleepers, pinball.
[[nodiscard]] std::vector<Regime> regimes();
/// Gas and rain at 1,000 to 100,000 balls, the fewest first.
[[nodiscard]] std::vector<Regime> growth();

}  // namespace flipside::bench
