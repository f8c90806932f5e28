#pragma once
/// Gates for discrete collision detection. The rule is in world/gate.hpp.

#include <algorithm>

#include "custom/geometry/narrow_phase.hpp"
#include "custom/touch_list.hpp"
#include "world/gate.hpp"

namespace flipside::custom {

/// Decides for each ball that overlaps a gate whether the gate lets it through, and keeps the gate open as
/// long as such a ball overlaps it. The balls have moved between `begin` and `end`, s after the table's time.
/// `each_candidate(visit)` must call visit(ball, previous centre) for each ball whose box overlaps that of
/// the gate; it may call it for others. `tests` counts the narrow-phase tests.
void decide_gate(Table& table, PartIndex part, double begin, double end, const std::vector<Ball>& balls,
                 std::uint64_t& tests, auto&& each_candidate) {
    const shape::Gate& gate = *gate_of(table.scene().parts[part]);
    const Pose before = table.pose(part, begin), now = table.pose(part, end);
    const Primitive line{primitive::Segment{gate.a, gate.b}, part};
    const auto separation = [&](const Ball& ball) {
        ++tests;
        return touch(ball.position, ball.radius, line, now).separation;
    };
    std::erase_if(table.blocked(), [&](const Blocked& blocked) {
        if (blocked.gate != part) return false;
        const Ball* ball = find_ball(balls, blocked.ball);
        return ball != nullptr && separation(*ball) > touch_distance * ball->radius;
    });
    const bool was_open = table.parts()[part].open;
    bool occupied = false;
    each_candidate([&](const Ball& ball, Vec2 previous) {
        if (separation(ball) >= 0) return;
        const bool is_blocked = !was_open && (table.is_blocked(part, ball.number) ||
                                              !lets_through(gate, before.undo(previous),
                                                            rotated(ball.velocity, -now.angle), ball.radius));
        occupied = occupied || !is_blocked;
        if (is_blocked) table.set_blocked(part, ball.number, true);
    });
    table.set_open(part, occupied);
    if (occupied) std::erase_if(table.blocked(), [&](const Blocked& b) { return b.gate == part; });
}

}  // namespace flipside::custom
