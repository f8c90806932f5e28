#pragma once
/// Finds the first wrong decision of a run (blame.hpp).

#include <span>

#include "lab/blame/blame.hpp"
#include "lab/blame/history.hpp"

namespace flipside::lab {

/// A run that ended, or stopped, away from where it must end.
struct Divergence {
    const Scene& scene;
    const History& history;          ///< of the contender
    std::span<const KnownEnd> ends;  ///< by rising number, at least one
    double error = 0;                ///< radii, of the worst of these balls, > 0; infinite where it failed
    World* own = nullptr;  ///< the contender's world, for steps made again with a trace; null: no evidence
};
/// `exact` is a world of the exact engine for the same scene. The states of both worlds mean nothing
/// afterwards. Cost:
/// about log2(steps) + 6 runs of it as long as the history at most.
[[nodiscard]] Blame find_blame(const Divergence& divergence, World& exact);

}  // namespace flipside::lab
