#pragma once
/// The regimes in which speed is measured: what a step costs depends on what the balls do.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "world/scene.hpp"

namespace flipside::lab::regimes {

inline constexpr double dt = 1.0 / 60;  // s, of every step

/// A stretch of a course in which the balls do one thing.
struct Regime {
    std::string name;
    double from = 0, seconds = 0;  ///< of simulated time, in whole slices (measure.hpp)
    bool is_kind = false;          ///< a kind of scene of its own, for which a setting is to be picked
};

/// A scene from its beginning to the end of its last regime.
struct Course {
    int balls = 0;
    /// One scene, or several, whose steps count alike.
    std::function<std::vector<std::shared_ptr<const Scene>>()> scenes;
    std::vector<Regime> regimes;  ///< in the order of their beginnings; they may overlap
    bool bare = true;             ///< the bare loop knows its shapes
    bool keeps_energy = false;    ///< nothing is inelastic
};

/// Gas, rain that falls, heaps up and lies in heaps, sleepers, pinball, the toy.
[[nodiscard]] std::vector<Course> courses();
/// Rain of 3,200 that settles and heaps up; at its end one ball in twenty still falls. With Box2D it takes
/// ten minutes of CPU time.
[[nodiscard]] std::vector<Course> heaps();
/// Gas and rain at 1,000 to 100,000 balls, the fewest first.
[[nodiscard]] std::vector<Course> growth();

}  // namespace flipside::lab::regimes
