#pragma once
/// What the exact engine makes of a contender's state.

#include <span>

#include "lab/blame/history.hpp"

namespace flipside::lab {

/// Lets the world go on from the state to `time`, by the script of the history; the events of kinds impact
/// and begin on the way. Controls at or after the state's time and before `time` are applied, to 1e-9 s. Its
/// steps are long, but where balls are launched, which happens between steps, those of the history. Throws
/// Refusal.
std::vector<Event> go_on(World& world, const State& state, double time, const History& history);

/// Whether position, velocity, angle and spin are all numbers.
[[nodiscard]] bool is_number(const Ball& ball);

/// The ball that is furthest from where it must be.
struct Worst {
    double radii = 0;  ///< infinite where a ball is gone, is no number, or the world refuses
    BallNumber ball = 0;
};
/// Of the world as it is. `ends` by rising number; no ball outside of them counts.
[[nodiscard]] Worst worst(std::span<const Ball> balls, std::span<const KnownEnd> ends);
/// After the exact engine went on from the state to the end of the run.
[[nodiscard]] Worst worst_if_exact_from(const State& state, const History& history,
                                        std::span<const KnownEnd> ends, World& exact);

}  // namespace flipside::lab
