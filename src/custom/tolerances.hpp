#pragma once
/// Tolerances that more than one part of the engine relies on, all in ball radii, and their order.

namespace flipside::custom {

/// Overlaps up to this are rounding and left alone.
inline constexpr double overlap_slop = 1e-9;
/// Surfaces nearer than this count as touching.
inline constexpr double touch_distance = 1e-4;

static_assert(overlap_slop < touch_distance, "what overlaps must touch");

}  // namespace flipside::custom
