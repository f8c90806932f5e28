#pragma once
/// Tolerances of length that more than one part of the engine relies on, all in ball radii, and their order.
/// What only one file uses stands there.

namespace flipside::custom {

/// Overlaps up to this are rounding and left alone.
inline constexpr double overlap_slop = 1e-9;
/// A gap up to this is contact for a ball that does not move along the normal.
inline constexpr double support_gap = 1e-9;
/// Surfaces nearer than this count as touching.
inline constexpr double touch_distance = 1e-4;
/// Surfaces nearer than this can press on each other.
inline constexpr double press_distance = 1e-3;
/// Overlaps deeper than this are no rounding: what starts so is pushed out or joins an island.
inline constexpr double deep_overlap = 1e-3;
/// A ball that overlaps anything by more than this does not fall asleep: it is on its way out.
inline constexpr double squeezed_overlap = 5e-3;

static_assert(support_gap <= touch_distance, "what supports a ball touches it");
static_assert(overlap_slop < touch_distance, "what overlaps must touch");
static_assert(touch_distance < press_distance, "what touches may press");
static_assert(press_distance <= deep_overlap, "balls deep in each other press on each other");
static_assert(deep_overlap < squeezed_overlap, "islands push out what keeps their balls awake");

}  // namespace flipside::custom
