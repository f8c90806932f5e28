#pragma once
/// Impacts made up by hand, for the tests of what compares two runs.

#include "world/events.hpp"

namespace flipside::lab {

/// Of ball and part; it happens at the origin with an impulse of 1.
inline Event impact(double time, BallNumber ball, PartIndex part) {
    return {time, EventKind::impact, ball, Other::part(part), {}, {}, 1, 0};
}

}  // namespace flipside::lab
