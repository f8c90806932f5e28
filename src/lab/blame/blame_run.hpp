#pragma once
/// Blame for a long run: that of its first divergence from the reference.

#include <functional>

#include "lab/blame/blame.hpp"
#include "lab/contenders/contender.hpp"
#include "world/controls.hpp"

namespace flipside::lab {

/// A ball that is more than this many radii from where the reference has it has diverged.
inline constexpr double diverged_radii = 1;
/// Of the reference's claim: past it a ball is not judged any more.
inline constexpr double judged_radii = 1e-3;

struct RunBlame {
    std::optional<Blame> blame;  ///< nothing where no ball diverged
    double until = 0;            ///< s: of the divergence; or up to here there is none
    double radii = 0;            ///< how far the worst ball was then; infinite where one is gone
    BallNumber ball = 0;         ///< that ball
    std::string why;             ///< why nothing is known after `until`; "" where it is the end of the run
};
/// Runs the contender and the reference (53 bits, with its twin) side by side until the first ball diverges,
/// all balls are past the reference's horizon, one of the two cannot go on, or the time is over. `watch` is
/// called after each step with its time.
[[nodiscard]] RunBlame blame_run(const std::shared_ptr<const Scene>& scene, const Contender& contender,
                                 double seconds, const Script& script,
                                 const std::function<void(double)>& watch);

}  // namespace flipside::lab
