#pragma once
/// Blame: the first wrong decision of a run that ended in another place than the exact one.
///
/// Take the contender's state after each of its steps, and let the exact engine go on from there to the end
/// of the run: D(k) is how far the worst ball then is from where it must be. D(0) is 0, and D(last) is the
/// error of the run. The decision that is blamed lies in the step in which D passes the tolerance, half of
/// the error but at most `most_tolerance`: before that step an exact engine could still have saved the run,
/// after it none can. So an error that a bumper amplifies later is charged to the step that made it, not to
/// the bumper. What is wrong in that step is found by the exact engine's own step from the same state.
///
/// D need not rise all the way; the step is found by bisection, so it is one in which D passes the tolerance
/// from below, and the first where D passes only once.

#include <optional>
#include <string>

#include "world/events.hpp"

namespace flipside::lab {

/// Half of an error, radii, up to this: once a ball is a radius off, what it meets is another story.
inline constexpr double most_tolerance = 1;

/// Impacts of two runs are the same one where ball and other are the same and the times differ by no more
/// than this, s: a step, since some engines only know the step, and 5 ms, in which a slow ball may yet sink
/// through a solver's slop.
[[nodiscard]] inline double match_tolerance(double dt) {
    return dt + 5e-3;
}

/// Exhaustive and exclusive: every divergence has one.
enum class Fault {
    drift,        ///< the path in flight is not exact; nothing was met
    missed,       ///< a contact that should be is not made although the pair was found and overlaps
    unpaired,     ///< the same, and the broad phase did not find the pair
    tunnelled,    ///< it lay between two steps, and after the second the ball is past it
    let_through,  ///< it is a gate that should have been closed
    invented,     ///< a contact is made that should not be
    late,         ///< the right contact, but later, or at a place further on
    early,        ///< or earlier
    normal,       ///< at the right time, but along another normal
    impulse,      ///< at the right time and normal, but with another impulse: restitution, kick
    friction,     ///< all that is right but the tangential impulse
    resting,      ///< a contact that presses or slides, or one too slow to bounce, is not held exactly
    motion,       ///< what was met moves by itself and is in another place than it should be
    stopped,      ///< the run ended before its time: refused, or not a number
    unknown       ///< none of these
};
inline constexpr std::string_view fault_names[] = {
    "drift",  "missed",  "unpaired", "tunnelled", "let-through", "invented", "late",   "early",
    "normal", "impulse", "friction", "resting",   "motion",      "stopped",  "unknown"};
constexpr std::string_view name_of(Fault fault) {
    return fault_names[static_cast<int>(fault)];
}
/// The stage of a step that such a fault comes from: integration, broad phase, narrow phase, continuous
/// collision, time of impact, response.
[[nodiscard]] std::string_view stage_of(Fault fault);
/// "late by 0.0021 s", "normal off by 3.1 degrees": what the amount of such a fault means, in words.
[[nodiscard]] std::string in_words(Fault fault, double amount);

/// What kind of thing was met. "none" belongs to faults that met nothing.
inline constexpr std::string_view met_kinds[] = {"none",    "point", "segment", "arc",  "circle",
                                                 "polygon", "taper", "flipper", "gate", "ball"};

struct Blame {
    Fault fault = Fault::unknown;
    std::string kind = "none";   ///< one of met_kinds
    std::optional<Other> other;  ///< what was met; nothing in flight
    BallNumber ball = 0;
    double time = 0;  ///< s, of the exact impact; where there is none, of the contender's or the step's end
    /// drift, resting: m from the exact path. missed and its kin, invented: m/s of approach. late, early: s.
    /// normal: rad. impulse, friction: m/s by which the velocity after it differs. motion: rad of the part.
    /// Never below 0.
    double amount = 0;
};

/// "late by 0.0021 s at arc 'top', ball 0, 1.234 s (time of impact)"; printable.
[[nodiscard]] std::string in_words(const Blame& blame, const Scene& scene);

}  // namespace flipside::lab
