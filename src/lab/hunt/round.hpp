#pragma once
/// One round of a hunt: random scenes, then climbing from the worst of them, then shrinking what was found. A
/// round depends on its request and its number alone, so rounds can be made in any order, anywhere.

#include <functional>

#include "lab/hunt/goal.hpp"

namespace flipside::lab::hunt {

struct Request {
    ContenderRequest contender;
    double dt = default_step;  ///< s, where the contender says nothing else
    Goal goal = Goal::overlap;
    double seconds = 1;  ///< of each run
    std::uint64_t seed = 1;
    std::size_t scenes = 2000;  ///< that each round looks at, shrinking apart
    std::size_t rounds = 4;
};

struct Found {
    std::string text;  ///< scene file, one line
    Measured measured;
    std::size_t balls = 0, parts = 0;
};

/// How bad the request's contender is on a scene.
[[nodiscard]] Measured measure(const Request& request, const Scene& scene);

/// At least one scene was valid: otherwise throws Failure. `watch` is told the share done, and may throw.
[[nodiscard]] Found hunt_round(const Request& request, std::size_t round,
                               const std::function<void(double)>& watch);

/// Smaller scenes that are at least `keep` times as bad: fewer balls, parts and motions, plain materials,
/// round numbers; until none of them is.
[[nodiscard]] Found shrunk(const Request& request, const Found& found, const std::function<void()>& watch);
inline constexpr double keep = 0.8;

}  // namespace flipside::lab::hunt
