#include <algorithm>

#include "custom/continuous/continuous_solver.hpp"
#include "custom/engine.hpp"
#include "world/limits.hpp"

namespace flipside::custom {

namespace {

/// An approach slower than this part of the speed is a joint's or rounding's: the ball slides on.
constexpr double graze = 1e-9;
/// So many events of a ball at one instant cannot be put in order.
constexpr int most_at_once = 200;
/// So many events of a ball without an impact that counts lead nowhere. Hops of an impact slower than this,
/// in units of √(r·g), reach 1e-10 radii; balls that are pressed together rattle so.
constexpr int most_idle = 2000;
constexpr double idle_impact = 1e-5;
/// Steps of all searches for impacts in one window, about a fifth of a second; and for each ball as many as
/// 20 grazes take.
constexpr std::uint64_t most_search_steps = 2'000'000, search_steps_per_ball = 1000;
/// Events less than this part of the step apart are at one instant.
constexpr double instant = 1e-12;

}  // namespace

/// Moves a ball along its path.
void ContinuousSolver::advance(Ball& ball, const HeldPath& way, double time) {
    const auto [position, velocity] = way.path.at(time);
    ball.position = position;
    ball.velocity = velocity;
    const double spin = way.spin_at(ball.spin, time);
    ball.angle += (ball.spin + spin) / 2 * (time - way.path.start);  // exact where the spin changes evenly
    ball.spin = spin;
}

/// Handles the next event of a ball.
void ContinuousSolver::handle(Place i) {
    Mover& mover = movers_[i];
    const double time = mover.next_time;
    // Of two balls the first is held to have the event.
    Mover& counted = mover.next == Next::ball ? movers_[std::min(i, mover.met)] : mover;
    counted.stalled = time <= counted.last_time + instant * dt_ ? counted.stalled + 1 : 0;
    counted.last_time = time;
    if (counted.stalled > most_at_once || ++counted.idle > most_idle) return hand_over(i);
    if (++events_ > settings_.max_impacts ||
        search_steps_ > most_search_steps + search_steps_per_ball * movers_.size()) {
        for (Place j = 0; j < movers_.size(); ++j) hand_over(j);
        return;
    }
    mover.left = nullptr;
    apart_ = false;
    switch (mover.next) {
        case Next::feature:
            if (ignores(features_[mover.met], bodies_[i])) return predict(i, time);
            return hit_feature(i, time);
        case Next::ball:
            if (movers_[mover.met].changes != mover.met_changes) return predict(i, time);
            return hit_ball(i, time);
        case Next::look_again:
            advance(bodies_[i], movers_[i].way, time);
            if (mover.way.lets_go) mover.left = mover.held;
            return go_on(i, time);
        case Next::sense:
            return sense(i, time);
        case Next::leave_bounds:
            return lose(i, time);
        case Next::nothing:
            return;
    }
}

void ContinuousSolver::go_on(Place i, double time) {
    set_out(i, time);
    predict(i, time);
}

void ContinuousSolver::report(double time, EventKind kind, const Ball& ball, Other other,
                              const Impact& impact, Vec2 point) {
    if (!within_top_speed(ball)) refuse_speed(engine_name, ball, other, start_ + time, scene_);
    pending_.push_back(
        {start_ + time, kind, ball.number, other, point, impact.normal, impact.speed, impact.impulse});
}

bool ContinuousSolver::leads_on(const Impact& impact, const Ball& ball) const {
    return impact.speed > idle_impact * std::sqrt(ball.radius * length(scene_.gravity));
}

void ContinuousSolver::hit_feature(Place i, double time) {
    Ball& ball = bodies_[i];
    const Feature& feature = features_[movers_[i].met];
    const PartIndex index = feature.part;
    const Part& part = scene_.parts[index];
    const Turning& turning = turnings_[index];
    const Pose pose = turning.pose(time);
    advance(bodies_[i], movers_[i].way, time);
    const Sight sight = look(feature, pose.undo(ball.position), ball.radius);
    if (feature.gate && meet_gate(i, index, time)) return go_on(i, time);
    const Vec2 normal = pose.angle == 0 ? sight.normal : rotated(sight.normal, pose.angle);
    const Vec2 point = ball.position - sight.distance * normal;
    const Vec2 surface = cross(turning.rate_at(time), point - pose.pivot);
    const Vec2 relative = ball.velocity - surface;
    ball.asleep = false;
    if (const double closing = -dot(relative, normal); closing <= graze * length(relative)) {
        if (closing > 0) ball.velocity += closing * normal;
        return go_on(i, time);
    }
    const Touch touch{point, normal, 0, 0, false};
    const Impact impact = respond(ball, touch, surface, layout_.mixed(ball.material, part.material),
                                  {scene_.gravity, scene_.rest_speed, 0});
    if (impact.happened) {
        ++record_->statistics.impacts;
        if (leads_on(impact, ball)) movers_[i].idle = 0;
        report(time, EventKind::impact, ball, Other::part(index), impact, point);
        if (part.target) {
            table_->set_down(index, true);
            release(index, time);
        }
    }
    go_on(i, time);
}

/// What lay on a part goes on without it.
void ContinuousSolver::release(PartIndex part, double time) {
    for (Place j = 0; j < movers_.size(); ++j) {
        Ball& ball = bodies_[j];
        if (movers_[j].handed_over || movers_[j].lost) continue;
        if (!ball.asleep && (movers_[j].held == nullptr || movers_[j].held->part != part)) continue;
        if (!ball.asleep) advance(bodies_[j], movers_[j].way, time);
        ball.asleep = false;
        go_on(j, time);
    }
}

void ContinuousSolver::hit_ball(Place i, double time) {
    const Place j = movers_[i].met;
    const Place low = std::min(i, j), high = std::max(i, j);
    Ball &a = bodies_[low], &b = bodies_[high];
    advance(bodies_[low], movers_[low].way, time);
    advance(bodies_[high], movers_[high].way, time);
    a.asleep = b.asleep = false;
    movers_[j].left = nullptr;
    const Impact impact =
        respond(a, b, false, layout_.mixed(a.material, b.material), {scene_.gravity, scene_.rest_speed, 0});
    if (impact.happened) {
        ++record_->statistics.impacts;
        if (leads_on(impact, a)) movers_[i].idle = movers_[j].idle = 0;
        report(time, EventKind::impact, a, Other::ball(b.number), impact,
               b.position + b.radius * impact.normal);
        if (!within_top_speed(b)) refuse_speed(engine_name, b, Other::ball(a.number), start_ + time, scene_);
    }
    set_out(i, time);
    set_out(j, time);
    // A slow touch of balls that are driven together lasts.
    if (!impact.happened && pressing(low, high, time) > 1e-9 * length(scene_.gravity)) {
        hand_over(i);
        return hand_over(j);
    }
    predict(i, time);
    predict(j, time);
}

void ContinuousSolver::lose(Place i, double time) {
    Ball& ball = bodies_[i];
    const Vec2 p = movers_[i].way.path.position(time);
    report(time, EventKind::lost, ball, {}, {}, p);
    if (scene_.keep_lost) {
        table_->reported_lost().push_back(ball.number);
        return predict(i, time);
    }
    movers_[i].lost = true;
    ++movers_[i].changes;
    std::erase_if(table_->blocked(), [&](const Blocked& blocked) { return blocked.ball == ball.number; });
    for (PartIndex part = 0; part < pieces_.size(); ++part) {
        if (!inside(ball.number, part)) continue;
        if (!scene_.parts[part].sensor) {
            leave_gate(ball.number, part, time);
            continue;
        }
        set_inside(ball.number, part, false);
        report(time, EventKind::sensor_end, ball, Other::part(part), {}, {});
    }
}

bool ContinuousSolver::inside(BallNumber ball, PartIndex part) const {
    return std::ranges::binary_search(inside_, Sensed{ball, part});
}

void ContinuousSolver::set_inside(BallNumber ball, PartIndex part, bool is_inside) {
    const Sensed sensed{ball, part};
    const auto at = std::ranges::lower_bound(inside_, sensed);
    const bool was = at != inside_.end() && *at == sensed;
    if (is_inside && !was) inside_.insert(at, sensed);
    if (!is_inside && was) inside_.erase(at);
}

/// A ball enters or leaves a sensor, or leaves a gate.
void ContinuousSolver::sense(Place i, double time) {
    const Ball& ball = bodies_[i];
    const PartIndex part = movers_[i].met;
    if (scene_.parts[part].sensor) {
        const bool enters = !inside(ball.number, part);
        set_inside(ball.number, part, enters);
        const EventKind kind = enters ? EventKind::sensor_begin : EventKind::sensor_end;
        report(time, kind, ball, Other::part(part), {}, {});
    } else {
        leave_gate(ball.number, part, time);
    }
    predict(i, time);
}

}  // namespace flipside::custom
