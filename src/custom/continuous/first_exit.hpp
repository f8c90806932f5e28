#pragma once
/// When a path first leaves a box. Between the instants at which one of its coordinates may turn, both
/// coordinates are monotone: the path leaves in such an interval only if it is outside at its end, and then
/// bisection finds when. Nothing is searched by steps, so a ball on the border, along it or grazing it costs
/// the same as any other.

#include "custom/continuous/path.hpp"

namespace flipside::custom {

/// First time in [t0, t1] at which box.contains(path.position(t)) is false, to one rounding of the time;
/// never_touch if there is none. Cost: up to four positions for a flight that stays inside, up to about
/// 0.5 ms for one that swings (all zeros of the derivatives of its two polynomials).
[[nodiscard]] double first_exit(const Path& path, const Box& box, double t0, double t1);

}  // namespace flipside::custom
