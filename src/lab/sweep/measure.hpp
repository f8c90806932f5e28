#pragma once
/// One contender on one window: how far from the exact outcome, and at what cost.

#include <limits>

#include "lab/blame/find_blame.hpp"
#include "lab/sweep/windows.hpp"

namespace flipside::lab::sweep {

/// Why a run failed; "" where it did not.
inline constexpr std::string_view failures[] = {"", "refused", "not a number", "lost ball"};

/// What a contender made of a window.
struct Outcome {
    std::string failure;       ///< one of `failures`; its errors are infinite where it failed
    double error = 0;          ///< radii: position at the end, the worst ball whose end is known
    double typical = 0;        ///< radii: the same, the median over the known balls that were hit
    std::size_t impacts = 0;   ///< of the reference
    std::size_t missed = 0;    ///< of these, without a match
    std::size_t spurious = 0;  ///< of the contender, without a match
    std::string why{};         ///< of what was refused, in the engine's words; not kept in files
};

/// Impacts of each run that the other has not, matched in order of time per ball and other. One that lies
/// within `tolerance` of `end` and has no match may have had it after the end, and is not counted.
struct Unmatched {
    std::size_t first = 0, second = 0;
};
[[nodiscard]] Unmatched count_unmatched(std::span<const Event> first, std::span<const Event> second,
                                        double tolerance, double end);

/// Runs the world, made for the window's scene, from the window's start in steps of dt, which divides its
/// length. Engines' exceptions become failures, and so does a run that has taken more than `most_seconds` of
/// CPU time after a step. What it did is added to `history`, which must be empty.
[[nodiscard]] Outcome run_window(World& world, const Window& window, double dt, History& history,
                                 double most_seconds = std::numeric_limits<double>::infinity());
/// The outcome where the world could not even be made.
[[nodiscard]] Outcome refused_window(const Window& window, double dt, const std::string& why);
/// A run diverged whose error is above exact_radii. Its first wrong decision; `own` is the world that ran, or
/// null, `exact` one of the reference for the scene, in double precision. What they hold is lost.
[[nodiscard]] bool diverged(const Outcome& outcome);
[[nodiscard]] Blame blame_of(const Outcome& outcome, const Window& window, const History& history,
                             const Scene& scene, World* own, World& exact);
/// CPU time of the same steps and nothing else, s, once the caches know the world.
[[nodiscard]] double time_window(World& world, const Window& window, double dt);

}  // namespace flipside::lab::sweep
