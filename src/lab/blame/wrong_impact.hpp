#pragma once
/// What is wrong with an impact that two engines made from the same state in the same step.

#include "lab/blame/blame.hpp"

namespace flipside::lab {

struct ImpactPair {
    const Event &own, &exact;
    const Ball &own_ball, &exact_ball;  ///< after the step
    Vec2 approach;      ///< m/s of that ball relative to what it meets, before the exact impact
    bool rubs = false;  ///< the friction between the two is above 0
    /// rad by which the contender's normal differs from that of the surface where the contender has the ball
    double misread = 0;
    double time = 0;  ///< s, end of the step
    double end = 0;   ///< s, end of the run: until then a wrong velocity carries on
};

struct WrongImpact {
    Fault fault = Fault::unknown;  ///< late, early, normal, impulse, friction or unknown
    double amount = 0;             ///< as in Blame
};
/// The difference of the two balls is taken apart:
///   - What the same law gives along the contender's normal in place of the exact one is the normal's; where
///   that
///     is the surface's own normal at the contender's place, the contact was made at that wrong place, and so
///     is late or early.
///   - What is left of the velocity is impulse along the exact normal, and friction across it. Where nothing
///   rubs,
///     a velocity across is that of a normal that the contender does not tell.
///   - What is left of the position, once the wrong velocity since the impact is taken off, is time too:
///   bouncing
///     late by t leaves a ball t times the change of velocity behind.
/// The one that moves the ball furthest until `end` is the fault; unknown where the balls are alike.
[[nodiscard]] WrongImpact compare_impacts(const ImpactPair& pair);

}  // namespace flipside::lab
