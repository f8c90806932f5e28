#pragma once
/// What a hand does to one thing of a scene's document, be it a part, a ball, the launcher or the bounds:
/// moves it and turns it. Pure functions of JSON; keys that they do not know stay. Lengths are rounded to 1
/// nm and angles to 1e-9 degrees, so that numbers stay short and joints close.

#include "lab/editor/sketch.hpp"

namespace flipside::lab {

/// Everything that has a place moves along: corners, centres, the pivot of a motion.
[[nodiscard]] OrderedJson moved(const OrderedJson& thing, Vec2 by);
/// Anticlockwise about a point, rad.
[[nodiscard]] OrderedJson turned(const OrderedJson& thing, Vec2 about, double angle);

/// Ends and corners to which others may join.
[[nodiscard]] std::vector<Vec2> joints_of(const OrderedJson& thing);
/// About what it turns: its pivot, or the middle of all its places.
[[nodiscard]] Vec2 middle_of(const OrderedJson& thing);
/// The direction that it shows, rad, of those shapes that have one: along a segment, from pivot to tip.
[[nodiscard]] std::optional<double> direction_of(const OrderedJson& thing);

}  // namespace flipside::lab
