#pragma once
/// Map of the stability of an engine: mass ratio × speed × step.
///
/// In a box of 2 m × 3 m (gravity 9.81 m/s², ball radius 0.1 m, e = 0.5 everywhere) a ball of mass 1 lies on
/// the floor, and a heavier one is thrown down at it, a little off centre. For two seconds nothing may leave
/// the box, no ball may stop being a number, and the energy may not rise above the first by more than 1 %
/// (nothing drives the balls); at the end none may overlap anything by more than a tenth of a radius.

#include <functional>
#include <iosfwd>
#include <span>
#include <string_view>
#include <vector>

#include "lab/comparison/compare.hpp"

namespace flipside::lab {

struct StabilityPoint {
    double mass_ratio;
    double speed;  ///< radii/s
    double dt;     ///< s
    std::string_view
        failure;         ///< "" where it holds; "energy", "escape", "overlap", "not a number", "refused"
    double energy_gain;  ///< largest over the run, relative to the first energy; below 0: none
    double overlap;      ///< deepest at the end, radii
};

inline constexpr double map_mass_ratios[] = {1, 10, 1e2, 1e3, 1e4, 1e6};
inline constexpr double map_speeds[] = {1, 10, 1e2, 1e3, 1e4, 1e6};
inline constexpr double map_steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 960};

/// All combinations, mass ratio by mass ratio, speed by speed, at these steps; some seconds of CPU at
/// map_steps. `watch` is called after each with the part done, 0 … 1.
[[nodiscard]] std::vector<StabilityPoint> stability_map(const Contender& contender,
                                                        std::span<const double> steps = map_steps,
                                                        const std::function<void(double)>& watch = {});

inline constexpr std::string_view stability_header =
    "engine,mass_ratio,speed_radii_per_s,dt,stable,failure,energy_gain,overlap_radii\n";
/// A row per point, under stability_header; `stable` is 0 or 1.
void write_stability(std::ostream& out, const Contender& contender, std::span<const StabilityPoint> points);

}  // namespace flipside::lab
