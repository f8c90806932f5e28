#include <algorithm>

#include "custom/continuous/continuous_solver.hpp"
#include "world/gate.hpp"

namespace flipside::custom {

/// Distance of a ball's surface from a sensor or gate, m; negative inside.
double ContinuousSolver::distance_to(PartIndex part, Vec2 center, double radius, const Pose& pose) const {
    double least = INFINITY;
    for (const PrimitiveIndex primitive : primitives_[part])
        least = std::min(least, touch(center, radius, layout_.primitive(primitive), pose).separation);
    return least;
}

/// Decides for each ball that overlaps a gate at the start of the window whether the gate lets it through:
/// such a ball had no impact event with the gate.
void ContinuousSolver::settle_gates() {
    for (const PartIndex part : layout_.gates()) settle_gate(part);
}

void ContinuousSolver::settle_gate(PartIndex part) {
    const auto [pose, rate, until_stop] = table_->turning(part, 0);
    const auto is_near = [&, &pose = pose](const Ball& ball) {
        const double out =
            std::max(gate_clearance * ball.radius, 4 * gap_rounding(ball.position, ball.radius));
        return layers_meet(ball, scene_.parts[part]) &&
               distance_to(part, ball.position, ball.radius, pose) < out;
    };
    const auto passes = [&, &pose = pose, &rate = rate](const Ball& ball) {
        if (table_->parts()[part].open || inside(ball.number, part)) return true;
        if (table_->is_blocked(part, ball.number)) return false;
        if (begins_deep(*gate_of(scene_.parts[part]), pose.undo(ball.position), ball.radius)) return true;
        const Vec2 relative = ball.velocity - cross(rate, ball.position - pose.pivot);
        return flipside::lets_through(*gate_of(scene_.parts[part]), pose.undo(ball.position),
                                      rotated(relative, -pose.angle), ball.radius);
    };
    const bool open =
        std::ranges::any_of(bodies_, [&](const Ball& ball) { return is_near(ball) && passes(ball); });
    table_->set_open(part, open);
    for (Ball& ball : bodies_) {
        const bool near = is_near(ball);
        const bool was_blocked = table_->is_blocked(part, ball.number);
        set_inside(ball.number, part, open && near);
        table_->set_blocked(part, ball.number, !open && near);
        if (open && was_blocked) ball.asleep = false;
    }
}

/// Whether the gate lets a ball through that touches it.
bool ContinuousSolver::lets_through(PartIndex part, const Ball& ball, double time) const {
    if (table_->parts()[part].open) return true;
    if (table_->is_blocked(part, ball.number)) return false;
    const Turning& turning = turnings_[part];
    const Pose pose = turning.pose(time);
    const Vec2 relative = ball.velocity - cross(turning.rate_at(time), ball.position - pose.pivot);
    return flipside::lets_through(*gate_of(scene_.parts[part]), pose.undo(ball.position),
                                  rotated(relative, -pose.angle), ball.radius);
}

/// Handles a ball that reaches a gate. Returns whether the gate lets it through; it is then open for all
/// balls.
bool ContinuousSolver::meet_gate(BallIndex i, PartIndex part, double time) {
    const Ball& ball = bodies_[i];
    if (!lets_through(part, ball, time)) {
        table_->set_blocked(part, ball.number, true);
        return false;
    }
    set_inside(ball.number, part, true);
    if (table_->parts()[part].open) return true;
    table_->set_open(part, true);
    std::erase_if(table_->blocked(), [&](const Blocked& blocked) {
        if (blocked.gate == part) set_inside(blocked.ball, part, true);
        return blocked.gate == part;
    });
    release(part, time);
    return true;
}

/// Handles a ball that has left a gate, whether the gate let it through or not.
void ContinuousSolver::leave_gate(BallNumber ball, PartIndex part, double time) {
    table_->set_blocked(part, ball, false);
    if (!inside(ball, part)) return;
    set_inside(ball, part, false);
    if (std::ranges::any_of(inside_, [&](const Sensed& s) { return s.sensor == part; })) return;
    table_->set_open(part, false);
    // Predictions made while the gate was open no longer hold.
    for (BallIndex j = 0; j < movers_.size(); ++j)
        if (movers_[j].number != ball && !bodies_[j].asleep && !hot_[j].lost) predict(j, time);
}

}  // namespace flipside::custom
