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
/// So many more, of one that had to wait for a tick.
constexpr int idle_after_wait = 20;
/// Steps of all searches for impacts in one window, about a fifth of a second; and for each ball as many as
/// 20 grazes take.
constexpr std::uint64_t most_search_steps = 2'000'000, search_steps_per_ball = 1000;
/// Events less than this part of the step apart are at one instant.
constexpr double instant = 1e-12;

}  // namespace

/// Moves a ball along its path.
void ContinuousSolver::advance(Ball& ball, const ConstrainedPath& way, double time) {
    const auto [position, velocity] = way.path.at(time);
    ball.position = position;
    ball.velocity = velocity;
    const double spin = way.spin_at(ball.spin, time);
    ball.angle += (ball.spin + spin) / 2 * (time - way.path.start);  // exact where the spin changes evenly
    ball.spin = spin;
}

/// Handles the next event of a ball.
void ContinuousSolver::handle(BallIndex i) {
    Mover& mover = movers_[i];
    if (mover.horizon <= mover.next_time) return enter_cell(i);
    const double time = mover.next_time;
    // Of two balls the first is held to have the event.
    Mover& counted =
        mover.next == Next::ball && !bodies_[mover.met].asleep ? movers_[std::min(i, mover.met)] : mover;
    counted.stalled = time <= counted.last_time + instant * dt_ ? counted.stalled + 1 : 0;
    counted.last_time = time;
    if (counted.stalled > most_at_once || ++counted.idle > most_idle) {
        counted.idle = most_idle - idle_after_wait;
        counted.stalled = 0;
        if (counted.crushed) return wait(&counted == &mover ? i : mover.met, time);
        return crush(i, time);
    }
    if (++events_ > settings_.max_impacts ||
        search_steps_ > most_search_steps + search_steps_per_ball * movers_.size()) {
        for (BallIndex j = 0; j < movers_.size(); ++j)
            if (!movers_[j].lost && !bodies_[j].asleep) wait(j, time);
        return;
    }
    mover.released = nullptr;
    switch (mover.next) {
        case Next::feature:
            if (ignores(features_[mover.met], bodies_[i])) return predict(i, time);
            return hit_feature(i, time);
        case Next::ball:
            if (flying_[mover.met].changes != mover.met_changes) return predict(i, time);
            return hit_ball(i, time);
        case Next::look_again:
            move_to(i, time);
            if (mover.way.separates) mover.released = mover.resting_on;
            return go_on(i, time);
        case Next::sense:
            return sense(i, time);
        case Next::leave_bounds:
            return lose(i, time);
        case Next::nothing:
            return;
    }
}

void ContinuousSolver::go_on(BallIndex i, double time) {
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

void ContinuousSolver::hit_feature(BallIndex i, double time) {
    Ball& ball = bodies_[i];
    const Feature& feature = features_[movers_[i].met];
    const PartIndex index = feature.part;
    const Part& part = scene_.parts[index];
    const Turning& turning = turnings_[index];
    const Pose pose = turning.pose(time);
    advance(ball, movers_[i].way, time);
    const Closest closest = closest_point(feature, pose.undo(ball.position), ball.radius);
    if (feature.gate && meet_gate(i, index, time)) return go_on(i, time);
    const Vec2 normal = pose.angle == 0 ? closest.normal : rotated(closest.normal, pose.angle);
    const Vec2 point = ball.position - closest.distance * normal;
    const Vec2 surface = cross(turning.rate_at(time), point - pose.pivot);
    if (const Vec2 v = true_velocity(i, time); - dot(v - surface, normal) > scene_.rest_speed)
        ball.velocity = v;
    const Vec2 relative = ball.velocity - surface;
    ball.asleep = false;
    if (const double closing = -dot(relative, normal); closing <= graze * length(relative)) {
        if (closing > 0) ball.velocity += closing * normal;
        return go_on(i, time);
    }
    const Touch touch{point, normal, 0, false};
    const Impact impact = respond(ball, touch, surface, layout_.mixed(ball.material, part.material),
                                  {scene_.gravity, scene_.rest_speed});
    if (impact.happened) {
        ++record_->statistics.impacts;
        if (leads_on(impact, ball)) movers_[i].idle = 0;
        report(time, EventKind::impact, ball, Other::part(index), impact, point);
        if (part.target) {
            table_->set_down(index, true);
            release(index, time);
        }
    }
    if (impact.happened) leave(i);
    go_on(i, time);
}

/// What lay on a part goes on without it.
void ContinuousSolver::release(PartIndex part, double time) {
    for (BallIndex j = 0; j < movers_.size(); ++j) {
        Ball& ball = bodies_[j];
        if (flying_[j].pressed || movers_[j].lost) continue;
        if (!ball.asleep && (movers_[j].resting_on == nullptr || movers_[j].resting_on->part != part))
            continue;
        if (!ball.asleep) advance(bodies_[j], movers_[j].way, time);
        ball.asleep = false;
        go_on(j, time);
    }
}

void ContinuousSolver::hit_ball(BallIndex i, double time) {
    const BallIndex j = movers_[i].met;
    const BallIndex low = std::min(i, j), high = std::max(i, j);
    Ball &a = bodies_[low], &b = bodies_[high];
    advance(a, movers_[low].way, time);
    advance(b, movers_[high].way, time);
    // A blow meets a member of an island with the velocity that it has; what comes to rest on one, with that
    // of its hop, so that both go on together until the next tick.
    const Vec2 u = true_velocity(low, time), v = true_velocity(high, time);
    if (-dot(u - v, unit(a.position - b.position)) > scene_.rest_speed) a.velocity = u, b.velocity = v;
    movers_[j].released = nullptr;
    // A sleeper holds against what merely comes to rest on it, and wakes when hit.
    const double approach = -dot(a.velocity - b.velocity, unit(a.position - b.position));
    const bool wakes = approach > settings_.sleep_speed && (a.asleep || b.asleep);
    if (wakes) a.asleep = b.asleep = false;
    Ball &hitting = a.asleep ? b : a, &other = a.asleep ? a : b;
    const double mass = other.mass;
    if (other.asleep) other.mass = INFINITY;
    const bool rattling = rattles(i, j, approach, time);
    const Impact impact = respond(hitting, other, layout_.mixed(a.material, b.material),
                                  {scene_.gravity, rattling ? slow_ : scene_.rest_speed});
    other.mass = mass;
    if (impact.happened) {
        ++record_->statistics.impacts;
        if (leads_on(impact, a)) movers_[i].idle = movers_[j].idle = 0;
        report(time, EventKind::impact, a, Other::ball(b.number), impact,
               b.position + (a.asleep ? -b.radius : b.radius) * impact.normal);
        if (!within_top_speed(b)) refuse_speed(engine_name, b, Other::ball(a.number), start_ + time, scene_);
    }
    // A slow touch of balls that are driven together lasts; a blow tears a ball out of its island.
    bool lasts = !impact.happened && (rattling || flying_[i].pressed || flying_[j].pressed);
    if (!impact.happened)
        for (Mover* mover : {&movers_[i], &movers_[j]}) {
            // One that touches others slowly again and again is between them.
            lasts = lasts || time - mover->last_slow < tick_length;
            mover->last_slow = time;
        }
    if (impact.happened) leave(i), leave(j);
    set_out(i, time);
    set_out(j, time);
    if (lasts || (!impact.happened && closing_acceleration(low, high, time) > 1e-9 * length(scene_.gravity)))
        join(i, time), join(j, time);
    predict(i, time);
    predict(j, time);
    if (wakes) wake_carried(i, time), wake_carried(j, time);
}

/// Wakes the sleepers that lie on a ball, and those on them: what carries them has moved.
void ContinuousSolver::wake_carried(BallIndex i, double time) {
    woken_.assign(1, i);
    for (std::size_t next = 0; next < woken_.size(); ++next) {
        const Ball& carrier = bodies_[woken_[next]];
        const Vec2 at = movers_[woken_[next]].way.path.position(time);
        cells_.each_near(woken_[next], [&](BallIndex j) {
            Ball& ball = bodies_[j];
            const double reach = carrier.radius + ball.radius,
                         near = touch_distance * std::min(carrier.radius, ball.radius);
            if (!ball.asleep || movers_[j].lost || length(ball.position - at) > reach + near ||
                !(dot(ball.position - at, scene_.gravity) < 0) || !layers_meet(carrier, ball))
                return;
            ball.asleep = false;
            woken_.push_back(j);
        });
    }
    for (const BallIndex j : std::span(woken_).subspan(1)) {
        set_out(j, time);
        join(j, time);
    }
    for (const BallIndex j : std::span(woken_).subspan(1)) predict(j, time);
}

void ContinuousSolver::lose(BallIndex i, double time) {
    Ball& ball = bodies_[i];
    const Vec2 p = movers_[i].way.path.position(time);
    report(time, EventKind::lost, ball, {}, {}, p);
    if (scene_.keep_lost) {
        table_->reported_lost().push_back(ball.number);
        return predict(i, time);
    }
    movers_[i].lost = true;
    flying_[i].meets = false;
    ++flying_[i].changes;
    cells_.remove(i);
    next_events_.set(i, INFINITY, 0);
    std::erase_if(table_->blocked(), [&](const Blocked& blocked) { return blocked.ball == ball.number; });
    for (PartIndex part = 0; part < primitives_.size(); ++part) {
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
void ContinuousSolver::sense(BallIndex i, double time) {
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
