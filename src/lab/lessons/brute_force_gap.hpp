#pragma once
/// How far a disc is from a primitive of the table, found without any cleverness: the nearest of many points
/// of its outline. What closest-point formulas are checked against.

#include "world/surface.hpp"
#include "world/trace.hpp"

namespace flipside::lab {

/// m, from `center` to the nearest of `points` equally spaced places on the outline of a primitive in the
/// pose of the scene file. Above the true distance d by less than s²/(8 d) where the outline is straight or
/// bulges towards the centre, s being the spacing, and never by more than s/2.
[[nodiscard]] double distance_by_brute_force(Vec2 center, const Primitive& primitive, int points);

/// The greatest difference, m, between the separations of disc and primitive that a traced step's narrow
/// phase found and those of 10⁴ points each. Looks at the first 1,000. 0 where there are none.
[[nodiscard]] double separation_off(const Trace& trace, const Scene& scene);

}  // namespace flipside::lab
