#pragma once
/// What a player, a script or the rules can do to a world. A script drives every engine alike, so a
/// recording is a script.

#include <variant>
#include <vector>

#include "world/scene.hpp"

namespace flipside {

namespace control {

/// Raise (or let fall) every flipper of one side.
struct Flip {
    Side side = Side::left;
    bool up = false;
};
/// Fire `count` balls one after another, each when the launcher looks and its place is free (see table.hpp).
/// `size` scales the launcher's ball: radius · size, mass · size³.
struct Launch {
    double strength = 1;  ///< 0…1
    int count = 1;        ///< 1…1000
    double size = 1;      ///< > 0

    friend bool operator==(const Launch&, const Launch&) = default;
};
/// Jerk the table: every ball's velocity changes by this, m/s, as seen from the table.
struct Nudge {
    Vec2 velocity;
};
/// Switch the turning parts on or off.
struct Rotate {
    bool on = false;
};
/// Raise drop targets again; an empty list means all.
struct RaiseTargets {
    std::vector<PartIndex> parts;
};

}  // namespace control

using Control =
    std::variant<control::Flip, control::Launch, control::Nudge, control::Rotate, control::RaiseTargets>;

struct TimedControl {
    double time = 0;  ///< s, ≥ 0
    Control control;
};

/// In order of time.
using Script = std::vector<TimedControl>;

}  // namespace flipside
