#pragma once
/// The handles of one thing of a scene's document, and what pulling at them does. Pure functions, as in
/// reshape.hpp.

#include "lab/editor/sketch.hpp"

namespace flipside::lab {

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
    Role role = Role::corner;
    std::size_t index = 0;
    Vec2 at;
    std::optional<Vec2> anchor{};         ///< from which angles are measured
    std::optional<std::size_t> member{};  ///< of a compound, whose handle it is

    [[nodiscard]] bool is(Role of, std::size_t at_index) const { return role == of && index == at_index; }
};

/// Of a thing at one of these places of a document: "parts", "balls", "launcher" or "bounds".
[[nodiscard]] std::vector<Handle> handles_of(const OrderedJson& thing);
/// The thing when that handle of it is pulled there. In a compound the ends that lie there move along. What
/// cannot be pulled so far gives way as far as it can.
[[nodiscard]] OrderedJson pulled(const OrderedJson& thing, const Handle& handle, Vec2 to);
/// The arc whose handle that is turns by the nearest multiple of so many degrees between the same ends.
[[nodiscard]] OrderedJson with_whole_sweep(const OrderedJson& thing, const Handle& handle, double degrees);
/// Without a corner, where enough of them are left.
[[nodiscard]] OrderedJson without_corner(const OrderedJson& thing, std::size_t corner);

/// s: a velocity is shown as the way of so long.
inline constexpr double velocity_seconds = 0.1;
/// How far from a ball's centre the arrow of its velocity begins, m: that of a ball at rest can be seized
/// too.
[[nodiscard]] double arrow_begin(const OrderedJson& ball);

}  // namespace flipside::lab
