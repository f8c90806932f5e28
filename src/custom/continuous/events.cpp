// Handles events: impacts, ends of paths, sensors, gates, and the loss of a ball.

#include <algorithm>

#include "custom/continuous/continuous_solver.hpp"
#include "custom/engine.hpp"
#include "world/gate.hpp"
#include "world/limits.hpp"

namespace flipside::custom {

namespace {

/// An approach slower than this part of the speed comes from rounding or from a smooth joint, and is no
/// impact.
constexpr double graze = 1e-9;
/// More events of a ball at one instant than this have no end: the ball is jammed. With parts alone there may
/// be more: a ball that a moving part squeezes against a wall can have hundreds of impacts, each faster than
/// the one before, until it gets out.
constexpr int most_at_once = 200, most_with_parts = 1000;
/// More events of a ball in a row without a significant impact than this have no end either. Impacts slower
/// than idle_impact, in units of √(r·g), are not significant: the bounce reaches 1e-10 radii. Balls in
/// resting contact can repeat them forever.
constexpr int most_idle = 2000;
constexpr double idle_impact = 1e-5;
/// A ball whose events follow each other faster than this for long is jammed too: a part that moves presses
/// it against another one, and each impact gives it new speed (e > 1, or a kick). It may be ahead of that
/// pace by most_ahead events.
constexpr double least_interval = 1.0 / 240'000;  // s
constexpr int most_ahead = 10'000;
/// Events of the last two kinds that a ball may have after it was jammed, before it is jammed again.
constexpr int events_after_jam = 20;
/// Limit on the steps of all root searches in one window: they take about a fifth of a second, and for each
/// ball as long as 20 grazing contacts.
constexpr std::uint64_t most_search_steps = 2'000'000, search_steps_per_ball = 1000;
/// Events less than this part of the window apart are at one instant.
constexpr double instant = 1e-12;

}  // namespace

/// Moves a ball along its path to `time`.
void ContinuousSolver::advance(Ball& ball, const ConstrainedPath& motion, double time) {
    const auto [position, velocity] = motion.path.at(time);
    ball.position = position;
    ball.velocity = velocity;
    const double spin = motion.spin_at(ball.spin, time);
    ball.angle +=
        (ball.spin + spin) / 2 * (time - motion.path.start);  // exact for a constant angular acceleration
    ball.spin = spin;
}

/// Counts an event of a ball, and tells whether that exceeds a limit: then its events have no end.
bool ContinuousSolver::exceeds_limits(Mover& mover, double time, bool with_ball) const {
    const bool at_once = time <= mover.last_event + instant * end_;
    mover.simultaneous_events = at_once ? mover.simultaneous_events + 1 : 0;
    mover.meets_balls = with_ball || (at_once && mover.meets_balls);
    mover.last_event = time;
    mover.events_until = std::max(mover.events_until, time) + least_interval;
    if (mover.events_until - time <= most_ahead * least_interval &&
        mover.simultaneous_events <= (mover.meets_balls ? most_at_once : most_with_parts) &&
        ++mover.idle_events <= most_idle)
        return false;
    mover.simultaneous_events = 0;
    mover.idle_events = most_idle - events_after_jam;
    const double soon = time + (most_ahead - events_after_jam) * least_interval;
    mover.events_until = std::min(mover.events_until, soon);
    return true;
}

/// Handles the next event of a ball.
void ContinuousSolver::handle(BallIndex i) {
    Mover& mover = movers_[i];
    if (mover.cell_exit <= mover.next_time) return enter_cell(i);
    const double time = mover.next_time;
    // An event of two balls is counted for the lower one.
    Mover& counted = mover.next == EventType::ball && !bodies_[mover.partner].asleep
                         ? movers_[std::min(i, mover.partner)]
                         : mover;
    if (exceeds_limits(counted, time, mover.next == EventType::ball)) {
        if (!counted.jammed) return solve_jammed(i, time);
        // Of two balls the counted one, or the other if that is frozen already.
        return freeze(&counted == &mover || counted.frozen ? i : mover.partner, time);
    }
    if (++events_ > settings_.max_impacts ||
        search_steps_ > most_search_steps + search_steps_per_ball * movers_.size()) {
        for (BallIndex j = 0; j < movers_.size(); ++j)
            if (!hot_[j].lost && !bodies_[j].asleep) freeze(j, time);
        return;
    }
    mover.separated_from = nullptr;
    switch (mover.next) {
        case EventType::feature:
            if (ignores(features_[mover.partner], bodies_[i])) return predict(i, time);
            return hit_feature(i, time);
        case EventType::ball:
            if (hot_[mover.partner].version != mover.partner_version) return predict(i, time);
            return hit_ball(i, time);
        case EventType::path_end:
            advance_to(i, time);
            if (mover.motion.separates) mover.separated_from = mover.resting_on;
            return restart(i, time);
        case EventType::sensor:
            return sense(i, time);
        case EventType::leave_bounds:
            return lose(i, time);
        case EventType::none:
            return;
    }
}

void ContinuousSolver::restart(BallIndex i, double time) {
    start_path(i, time);
    predict(i, time);
}

void ContinuousSolver::report(double time, EventKind kind, const Ball& ball, Other other,
                              const Impact& impact, Vec2 point) {
    if (!within_top_speed(ball)) refuse_speed(engine_name, ball, other, start_ + time, scene_);
    pending_.push_back(
        {start_ + time, kind, ball.number, other, point, impact.normal, impact.speed, impact.impulse});
}

bool ContinuousSolver::is_significant(const Impact& impact, const Ball& ball) const {
    return impact.speed > idle_impact * std::sqrt(ball.radius * length(scene_.gravity));
}

void ContinuousSolver::hit_feature(BallIndex i, double time) {
    Ball& ball = bodies_[i];
    const Feature& feature = features_[movers_[i].partner];
    const PartIndex index = feature.part;
    const Part& part = scene_.parts[index];
    const Turning& turning = turnings_[index];
    const Pose pose = turning.pose(time);
    advance(ball, movers_[i].motion, time);
    const auto [distance, normal, facing] = closest_point(feature, pose, ball.position, ball.radius);
    if (feature.gate && meet_gate(i, index, time)) return restart(i, time);
    const Vec2 point = ball.position - distance * normal;
    const Vec2 surface = cross(turning.rate_at(time), point - pose.pivot);
    if (const Vec2 v = true_velocity(i, time); - dot(v - surface, normal) > scene_.rest_speed)
        ball.velocity = v;
    const Vec2 relative = ball.velocity - surface;
    ball.asleep = false;
    if (const double closing = -dot(relative, normal); closing <= graze * length(relative)) {
        if (closing > 0) ball.velocity += closing * normal;
        return restart(i, time);
    }
    const Touch touch{point, normal, 0, false};
    const Impact impact = respond(ball, touch, surface, layout_.mixed(ball.material, part.material),
                                  {scene_.gravity, scene_.rest_speed});
    if (impact.happened) {
        ++record_->statistics.impacts;
        if (is_significant(impact, ball)) movers_[i].idle_events = 0;
        report(time, EventKind::impact, ball, Other::part(index), impact, point);
        if (part.target) {
            table_.set_down(index, true);
            release(index, time);
        }
    }
    if (impact.happened) leave_island(i);
    restart(i, time);
}

/// Starts new paths for the balls that rest on a part, after the part has stopped colliding.
void ContinuousSolver::release(PartIndex part, double time) {
    for (BallIndex j = 0; j < movers_.size(); ++j) {
        Ball& ball = bodies_[j];
        if (hot_[j].in_island || hot_[j].lost) continue;
        if (!ball.asleep && (movers_[j].resting_on == nullptr || movers_[j].resting_on->part != part))
            continue;
        if (!ball.asleep) advance(bodies_[j], movers_[j].motion, time);
        ball.asleep = false;
        restart(j, time);
    }
}

void ContinuousSolver::hit_ball(BallIndex i, double time) {
    const BallIndex j = movers_[i].partner;
    const BallIndex low = std::min(i, j), high = std::max(i, j);
    Ball &a = bodies_[low], &b = bodies_[high];
    advance(a, movers_[low].motion, time);
    advance(b, movers_[high].motion, time);
    // An impact sees the true velocity of a member. A ball that comes to rest on a member sees the velocity
    // of its parabola instead, so that both stay together until the next tick.
    const Vec2 u = true_velocity(low, time), v = true_velocity(high, time);
    if (-dot(u - v, unit(a.position - b.position)) > scene_.rest_speed) a.velocity = u, b.velocity = v;
    movers_[j].separated_from = nullptr;
    // A sleeping ball wakes only when it is hit; against slower contacts it has infinite mass.
    const double approach = -dot(a.velocity - b.velocity, unit(a.position - b.position));
    const bool wakes = approach > settings_.sleep_speed && (a.asleep || b.asleep);
    if (wakes) a.asleep = b.asleep = false;
    Ball &hitting = a.asleep ? b : a, &other = a.asleep ? a : b;
    const double mass = other.mass;
    if (other.asleep) other.mass = INFINITY;
    const bool collapsing = collapses(i, j, approach, time);
    const Impact impact = respond(hitting, other, layout_.mixed(a.material, b.material),
                                  {scene_.gravity, collapsing ? slow_ : scene_.rest_speed});
    other.mass = mass;
    if (impact.happened) {
        ++record_->statistics.impacts;
        if (is_significant(impact, a)) movers_[i].idle_events = movers_[j].idle_events = 0;
        report(time, EventKind::impact, a, Other::ball(b.number), impact,
               b.position + (a.asleep ? -b.radius : b.radius) * impact.normal);
        if (!within_top_speed(b)) refuse_speed(engine_name, b, Other::ball(a.number), start_ + time, scene_);
    }
    // A slow contact of balls that accelerate towards each other is a resting contact. An impact takes both
    // balls out of their islands.
    bool lasts = !impact.happened && (collapsing || hot_[i].in_island || hot_[j].in_island);
    if (!impact.happened)
        for (Mover* mover : {&movers_[i], &movers_[j]}) {
            // A ball with several slow contacts within a tick lies between other balls.
            lasts = lasts || time - mover->last_slow < tick_length;
            mover->last_slow = time;
        }
    for (const BallIndex k : {i, j}) {
        if (movers_[k].frozen) {
            stay_frozen(k, impact.happened ? bodies_[k].velocity : movers_[k].velocity_end, time);
            continue;
        }
        if (impact.happened) leave_island(k);
        start_path(k, time);
    }
    if (lasts || (!impact.happened && closing_acceleration(low, high, time) > 1e-9 * length(scene_.gravity)))
        join_island(i, time), join_island(j, time);
    predict(i, time);
    predict(j, time);
    if (wakes) wake_carried(i, time), wake_carried(j, time);
}

/// Wakes the sleeping balls that lie on a ball that has moved, and those that lie on them.
void ContinuousSolver::wake_carried(BallIndex i, double time) {
    woken_.assign(1, i);
    for (std::size_t next = 0; next < woken_.size(); ++next) {
        const Ball& carrier = bodies_[woken_[next]];
        const Vec2 at = movers_[woken_[next]].motion.path.position(time);
        cells_.query_neighbours(woken_[next], [&](BallIndex j) {
            Ball& ball = bodies_[j];
            const double reach = carrier.radius + ball.radius,
                         near = touch_distance * std::min(carrier.radius, ball.radius);
            if (!ball.asleep || hot_[j].lost || length(ball.position - at) > reach + near ||
                !(dot(ball.position - at, scene_.gravity) < 0) || !layers_meet(carrier, ball))
                return;
            ball.asleep = false;
            woken_.push_back(j);
        });
    }
    for (const BallIndex j : std::span(woken_).subspan(1)) {
        start_path(j, time);
        join_island(j, time);
    }
    for (const BallIndex j : std::span(woken_).subspan(1)) predict(j, time);
}

void ContinuousSolver::lose(BallIndex i, double time) {
    Ball& ball = bodies_[i];
    const Vec2 p = movers_[i].motion.path.position(time);
    report(time, EventKind::lost, ball, {}, {}, p);
    if (scene_.keep_lost) {
        table_.reported_lost().push_back(ball.number);
        return predict(i, time);
    }
    hot_[i].lost = true;
    ++hot_[i].version;
    cells_.remove(i);
    next_events_.set(i, INFINITY, 0);
    std::erase_if(table_.blocked(), [&](const Blocked& blocked) { return blocked.ball == ball.number; });
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

/// Handles a ball that enters or leaves a sensor, or leaves a gate.
void ContinuousSolver::sense(BallIndex i, double time) {
    const Ball& ball = bodies_[i];
    const PartIndex part = movers_[i].partner;
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
    const Pose pose = turnings_[part].pose(0);
    const auto is_near = [&](const Ball& ball) {
        const double out =
            std::max(gate_clearance * ball.radius, 4 * gap_rounding(ball.position, ball.radius));
        return layers_meet(ball, scene_.parts[part]) &&
               distance_to(part, ball.position, ball.radius, pose) < out;
    };
    const auto passes = [&](const Ball& ball) {
        return inside(ball.number, part) || lets_through(part, ball, 0) ||
               (!table_.is_blocked(part, ball.number) &&
                begins_deep(*gate_of(scene_.parts[part]), pose.undo(ball.position), ball.radius));
    };
    const bool open =
        std::ranges::any_of(bodies_, [&](const Ball& ball) { return is_near(ball) && passes(ball); });
    table_.set_open(part, open);
    for (Ball& ball : bodies_) {
        const bool near = is_near(ball);
        const bool was_blocked = table_.is_blocked(part, ball.number);
        set_inside(ball.number, part, open && near);
        table_.set_blocked(part, ball.number, !open && near);
        if (open && was_blocked) ball.asleep = false;
    }
}

/// Whether the gate lets a ball through that touches it.
bool ContinuousSolver::lets_through(PartIndex part, const Ball& ball, double time) const {
    if (table_.parts()[part].open) return true;
    if (table_.is_blocked(part, ball.number)) return false;
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
        table_.set_blocked(part, ball.number, true);
        return false;
    }
    set_inside(ball.number, part, true);
    if (table_.parts()[part].open) return true;
    table_.set_open(part, true);
    std::erase_if(table_.blocked(), [&](const Blocked& blocked) {
        if (blocked.gate == part) set_inside(blocked.ball, part, true);
        return blocked.gate == part;
    });
    release(part, time);
    return true;
}

/// Handles a ball that has left a gate, whether the gate let it through or not.
void ContinuousSolver::leave_gate(BallNumber ball, PartIndex part, double time) {
    table_.set_blocked(part, ball, false);
    if (!inside(ball, part)) return;
    set_inside(ball, part, false);
    if (std::ranges::any_of(inside_, [&](const Sensed& s) { return s.sensor == part; })) return;
    table_.set_open(part, false);
    // Predictions made while the gate was open no longer hold.
    for (BallIndex j = 0; j < movers_.size(); ++j)
        if (movers_[j].number != ball && !bodies_[j].asleep && !hot_[j].lost) predict(j, time);
}

}  // namespace flipside::custom
