#pragma once
/// Tolerances of length that several parts of the engine share, in ball radii, with their order. Tolerances
/// of a single file are defined there.

namespace flipside::custom {

/// Smaller overlaps are rounding and are ignored.
inline constexpr double overlap_slop = 1e-9;
/// A ball that does not move along the normal is in contact up to this gap.
inline constexpr double support_gap = 1e-9;
/// Surfaces closer than this are reported as touching.
inline constexpr double touch_distance = 1e-4;
/// Surfaces closer than this can be in resting contact in an island.
inline constexpr double resting_distance = 1e-3;
/// Surfaces closer than this can support a sleeping ball. Less wakes a heap whenever one of its balls makes a
/// small hop between two ticks.
inline constexpr double sleep_distance = 3e-3;
/// Surfaces farther apart than this need no search for contacts.
inline constexpr double near_margin = 4e-3;
/// Balls that start with a deeper overlap are pushed out of parts, and join an island with balls.
inline constexpr double deep_overlap = 1e-3;
/// The position correction of a small island may leave overlaps of this depth. A flying ball that a member is
/// moved into more deeply joins the island.
inline constexpr double corrected_overlap = 5e-3;
/// A ball with a deeper overlap does not fall asleep, since it is still being pushed out. A row of balls
/// between two walls that has no room for one of them stays below this.
inline constexpr double squeezed_overlap = 1e-2;

static_assert(support_gap <= touch_distance, "a support touches the ball");
static_assert(overlap_slop < touch_distance, "overlaps are contacts");
static_assert(touch_distance < resting_distance, "contacts may be resting contacts");
static_assert(resting_distance < sleep_distance, "sleeping balls lie on resting contacts");
static_assert(sleep_distance < near_margin, "no search misses a contact");
static_assert(resting_distance <= deep_overlap, "deep overlaps are resting contacts");
static_assert(deep_overlap < corrected_overlap, "islands correct deep overlaps");
static_assert(corrected_overlap < squeezed_overlap, "what islands leave keeps no ball awake");

}  // namespace flipside::custom
