#pragma once
/// When a path first leaves a box. Both coordinates are monotone between the instants at which one of them
/// may have an extremum. So the path leaves in such an interval only if it is outside at its end, and then
/// bisection finds the time. There is no stepping, so a ball that touches the border costs no more than
/// others.

#include "custom/continuous/path.hpp"

namespace flipside::custom {

/// First time in [t0, t1] at which box.contains(path.position(t)) is false, to one rounding of the time;
/// never_touch if there is none. Cost: up to four positions for a flight that stays inside, up to about
/// 0.5 ms for a Taylor polynomial (all zeros of the derivatives of both coordinates).
[[nodiscard]] double first_exit(const Path& path, const Box& box, double t0, double t1);

}  // namespace flipside::custom
