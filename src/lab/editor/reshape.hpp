#pragma once
/// What a hand does to one thing of a scene's document, be it a part, a ball, the launcher or the bounds:
/// moves it, turns it, or pulls at one of its handles. Pure functions of JSON; keys that they do not know
/// stay. Lengths are rounded to 1 nm and angles to 1e-9 degrees, so that numbers stay short and joints close.

#include "lab/editor/sketch.hpp"

namespace flipside::lab {

/// Everything that has a place moves along: corners, centres, the pivot of a motion.
[[nodiscard]] OrderedJson moved(const OrderedJson& thing, Vec2 by);
/// Anticlockwise about a point, rad.
[[nodiscard]] OrderedJson turned(const OrderedJson& thing, Vec2 about, double angle);

/// What can be pulled at.
enum class Role {
    corner,     ///< an end or corner: `index` counts them
    between,    ///< the middle of a side, from which a new corner comes: after corner `index`
    centre,     ///< of a circle, arc or ball: all of it moves
    radius,     ///< of a circle, ball or capsule
    arc_end,    ///< the other end and the angle of the arc stay; 0: from, 1: to
    arc_bulge,  ///< both ends stay
    tip,        ///< of a flipper: its length and angle of rest
    raised,     ///< of a flipper: where its tip goes
    pivot,      ///< of a turning motion
    velocity,   ///< of a ball: the head of an arrow as long as its way in a tenth of a second
    direction   ///< of the launcher
};

struct Handle {
    Role role;
    std::size_t index = 0;
    Vec2 at;
    std::optional<Vec2> anchor{};  ///< from which angles are measured

    [[nodiscard]] bool is(Role of, std::size_t at_index) const { return role == of && index == at_index; }
};

/// Of a thing at one of these places of a document: "parts", "balls", "launcher" or "bounds".
[[nodiscard]] std::vector<Handle> handles_of(const OrderedJson& thing);
/// The thing when that handle of it is pulled there. What cannot be pulled so far gives way as far as it can.
[[nodiscard]] OrderedJson pulled(const OrderedJson& thing, const Handle& handle, Vec2 to);
/// An arc that turns by so many degrees between the same ends; anything else as it is.
[[nodiscard]] OrderedJson with_sweep(const OrderedJson& thing, double degrees);
/// Without a corner, where enough of them are left.
[[nodiscard]] OrderedJson without_corner(const OrderedJson& thing, std::size_t corner);

/// Ends and corners to which others may join.
[[nodiscard]] std::vector<Vec2> joints_of(const OrderedJson& thing);
/// About what it turns: its pivot, or the middle of all its places.
[[nodiscard]] Vec2 middle_of(const OrderedJson& thing);
/// The direction that it shows, rad, of those shapes that have one: along a segment, from pivot to tip.
[[nodiscard]] std::optional<double> direction_of(const OrderedJson& thing);

/// s: a velocity is shown as the way of so long.
inline constexpr double velocity_seconds = 0.1;
/// How far from a ball's centre the arrow of its velocity begins, m: that of a ball at rest can be seized
/// too.
[[nodiscard]] double arrow_begin(const OrderedJson& ball);

}  // namespace flipside::lab
