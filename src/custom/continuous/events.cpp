#include "custom/continuous/events.hpp"

#include <algorithm>
#include <cmath>

#include "custom/broad_phase/capacity.hpp"
#include "custom/engine.hpp"
#include "world/limits.hpp"

namespace flipside::custom {

namespace {

/// An approach slower than this part of the speed comes from rounding or from a smooth joint, and is no
/// impact.
constexpr double graze = 1e-11;
/// More events of a ball at one instant than this have no end: the ball is jammed. With parts alone there may
/// be more: a ball that moving parts squeeze can have a thousand impacts within a nanosecond, each faster
/// than the one before, until it gets out.
constexpr int most_at_once = 200, most_with_parts = 3000;
/// More events of a ball in a row without a significant impact than this have no end either. Impacts slower
/// than idle_impact, in units of √(r·g), are not significant: the bounce reaches 1e-10 radii. Balls in
/// resting contact can repeat them forever.
constexpr int most_idle = 2000;
constexpr double idle_impact = 1e-5;
/// A ball that a moving part drives is jammed too if its events follow each other faster than this for long:
/// the part presses it against another one, and each impact gives it new speed (e > 1, or a kick). It may be
/// ahead of that pace by most_ahead events. Nothing feeds such events elsewhere: a light ball between a wall
/// and a heavy ball has 314,159 of them, but they end.
constexpr double least_interval = 1.0 / 240'000;  // s
constexpr int most_ahead = 10'000;
/// Events of the last two kinds that a ball may have after it was jammed, before it is jammed again.
constexpr int events_after_jam = 20;
/// Limit on the steps of all root searches in one window: they take about a fifth of a second, and for each
/// ball 2 ms, as long as 400 grazing contacts. A flipper under a heap of 210 balls needs 4.5 million.
constexpr std::uint64_t most_search_steps = 2'000'000, search_steps_per_ball = 20'000;
/// Events less than this part of the window apart are at one instant.
constexpr double instant = 1e-12;

}  // namespace

/// Counts an event of a ball. Returns whether that exceeds a limit: then its events have no end.
bool Events::count_event(Particle& particle, double time, bool with_ball) const {
    const bool at_once = time <= particle.last_event + instant * sim_.end;
    particle.simultaneous_events = at_once ? particle.simultaneous_events + 1 : 0;
    particle.meets_balls = with_ball || (at_once && particle.meets_balls);
    particle.last_event = time;
    particle.events_until = std::max(particle.events_until, time) + least_interval;
    const bool keeps_pace = particle.events_until - time <= most_ahead * least_interval ||
                            time - particle.last_driven > sim_.tick_length;
    if (keeps_pace &&
        particle.simultaneous_events <= (particle.meets_balls ? most_at_once : most_with_parts) &&
        ++particle.idle_events <= most_idle)
        return false;
    particle.simultaneous_events = 0;
    particle.idle_events = most_idle - events_after_jam;
    const double soon = time + (most_ahead - events_after_jam) * least_interval;
    particle.events_until = std::min(particle.events_until, soon);
    return true;
}

void Events::reserve(std::size_t balls) {
    reserve_for(woken_, balls);
}

void Events::handle(BallIndex i) {
    Particle& particle = sim_.particles[i];
    const bool leaves_cell = particle.cell_exit <= particle.next_time;
    const double time = leaves_cell ? particle.cell_exit : particle.next_time;
    if (sim_.search_steps > most_search_steps + search_steps_per_ball * sim_.particles.size() ||
        (!leaves_cell && handled_ >= sim_.settings.max_impacts)) {
        for (BallIndex j = 0; j < sim_.particles.size(); ++j)
            if (!sim_.hot[j].lost && !sim_.balls[j].asleep) islands_.freeze(j, time, sim_.tick_length);
        return;
    }
    if (leaves_cell) return predictions_.enter_cell(i);
    // An event of two balls is counted for the lower one.
    const bool with_ball = particle.next == EventType::ball;
    const BallIndex counted =
        with_ball && !sim_.balls[particle.partner].asleep ? std::min(i, particle.partner) : i;
    if (count_event(sim_.particles[counted], time, with_ball)) {
        if (!sim_.particles[counted].jammed) return islands_.solve_jammed(counted, time);
        // Of two balls the counted one, or the other if that is frozen already.
        const BallIndex held = sim_.particles[counted].frozen ? i : counted;
        return islands_.freeze(held, time, islands_.longest_freeze(held, time));
    }
    ++handled_;
    particle.separated_from = nullptr;
    switch (particle.next) {
        case EventType::feature:
            if (gates_.ignores(sim_.features[particle.partner], sim_.balls[i]))
                return predictions_.predict(i, time);
            return hit_feature(i, time);
        case EventType::ball:
            if (sim_.hot[particle.partner].version != particle.partner_version)
                return predictions_.predict(i, time);
            return hit_ball(i, time);
        case EventType::path_end:
            sim_.advance_to(i, time);
            if (particle.motion.separates) particle.separated_from = particle.resting_on;
            return restart(i, time);
        case EventType::sensor:
            enter_or_leave(i, particle.partner, time);
            return predictions_.predict(i, time);
        case EventType::leave_bounds:
            return lose(i, time);
        case EventType::none:
            return;
    }
}

void Events::restart(BallIndex i, double time) {
    paths_.start_path(i, time);
    predictions_.predict(i, time);
}

void Events::report(double time, EventKind kind, const Ball& ball, Other other, const Impact& impact,
                    Vec2 point) {
    if (!within_top_speed(ball)) refuse_speed(engine_name, ball, other, sim_.start + time, sim_.scene);
    const double on_clock = std::min(sim_.start + time, sim_.now);  // it can be later by rounding
    sim_.record->events.push_back(
        {on_clock, kind, ball.number, other, point, impact.normal, impact.speed, impact.impulse});
}

bool Events::is_significant(const Impact& impact, const Ball& ball) const {
    return impact.speed > idle_impact * std::sqrt(ball.radius * length(sim_.scene.gravity));
}

void Events::hit_feature(BallIndex i, double time) {
    Ball& ball = sim_.balls[i];
    const Feature& feature = sim_.features[sim_.particles[i].partner];
    const PartIndex index = feature.part;
    const Part& part = sim_.scene.parts[index];
    const Turning& turning = sim_.turnings[index];
    advance(ball, sim_.particles[i].motion, time);
    const auto [distance, normal, facing] =
        closest_point(feature, ball.position, ball.radius, turning.pose(time));
    if (feature.gate && meet_gate(i, index, time)) return restart(i, time);
    const Vec2 point = ball.position - distance * normal;
    const Vec2 surface = turning.velocity_at(point, time);
    if (const Vec2 v = sim_.true_velocity(i, time); - dot(v - surface, normal) > sim_.scene.rest_speed)
        ball.velocity = v;
    const Vec2 relative = ball.velocity - surface;
    ball.asleep = false;
    if (!turning.still()) sim_.particles[i].last_driven = time;
    if (const double closing = -dot(relative, normal); closing <= graze * length(relative)) {
        if (closing > 0) ball.velocity += closing * normal;
        return restart(i, time);
    }
    const Impact impact = respond(ball, {point, normal}, surface, sim_.layout.mixed(ball, part),
                                  {.rest_speed = sim_.scene.rest_speed});
    if (impact.happened) {
        ++sim_.record->statistics.impacts;
        if (is_significant(impact, ball)) sim_.particles[i].idle_events = 0;
        report(time, EventKind::impact, ball, Other::part(index), impact, point);
        if (part.target) {
            sim_.table.set_down(index, true);
            release(index, i, time);
        }
        sim_.leave_island(i);
    }
    restart(i, time);
}

/// Starts new paths for the balls that touch a part which has stopped colliding, all but the one that has hit
/// it, and wakes those that sleep on it. Members of islands are solved without it at the next tick.
void Events::release(PartIndex part, BallIndex hitting, double time) {
    const Pose pose = sim_.turnings[part].pose(time);
    for (BallIndex j = 0; j < sim_.particles.size(); ++j) {
        if (j == hitting || sim_.hot[j].in_island || sim_.hot[j].lost) continue;
        const Ball now = sim_.ball_at(j, time);
        // A ball that sleeps may lie above the part by sleep_distance.
        const double near = (now.asleep ? sleep_distance : touch_distance) * now.radius;
        if (gates_.distance_to(part, now.position, now.radius, pose) > near) continue;
        sim_.balls[j] = now;
        sim_.balls[j].asleep = false;
        restart(j, time);
        if (now.asleep) wake_carried(j, time);
    }
}

void Events::hit_ball(BallIndex i, double time) {
    const BallIndex j = sim_.particles[i].partner;
    const BallIndex low = std::min(i, j), high = std::max(i, j);
    Ball &a = sim_.balls[low], &b = sim_.balls[high];
    advance(a, sim_.particles[low].motion, time);
    advance(b, sim_.particles[high].motion, time);
    // An impact sees the true velocity of a member. A ball that comes to rest on a member sees the velocity
    // of its parabola instead, so that both stay together until the next tick.
    const Vec2 u = sim_.true_velocity(low, time), v = sim_.true_velocity(high, time);
    if (-dot(u - v, unit(a.position - b.position)) > sim_.scene.rest_speed) a.velocity = u, b.velocity = v;
    sim_.particles[j].separated_from = nullptr;
    // A sleeping ball wakes only when it is hit; against slower contacts it has infinite mass.
    const double approach = -dot(a.velocity - b.velocity, unit(a.position - b.position));
    const bool wakes = approach > sim_.settings.sleep_speed && (a.asleep || b.asleep);
    if (wakes) a.asleep = b.asleep = false;
    const bool collapsing = islands_.note_hit(i, j, approach, time);
    // Two balls, one of them a member, rest on each other as two members do. Else most contacts in a heap are
    // bounces of balls that have just left their island.
    const bool in_island = collapsing || sim_.hot[i].in_island || sim_.hot[j].in_island;
    const bool bounces = collide(low, high, in_island ? sim_.slow : sim_.scene.rest_speed, time);
    for (const BallIndex k : {i, j}) {
        if (sim_.particles[k].frozen) {
            islands_.stay_frozen(k, bounces ? sim_.balls[k].velocity : sim_.particles[k].velocity_end, time);
            continue;
        }
        if (bounces) sim_.leave_island(k);
        paths_.start_path(k, time);
    }
    // A slow contact with a member, or of balls that accelerate towards each other, is a resting contact.
    if (!bounces &&
        (in_island || islands_.closing_acceleration(low, high, time) > 1e-9 * length(sim_.scene.gravity)))
        sim_.join_island(i, time), sim_.join_island(j, time);
    predictions_.predict(i, time);
    predictions_.predict(j, time);
    if (wakes) wake_carried(i, time), wake_carried(j, time);
}

/// Gives two balls that touch their velocities after the impact, if they approach faster than `rest_speed`,
/// and reports it. Returns whether they do.
bool Events::collide(BallIndex low, BallIndex high, double rest_speed, double time) {
    Ball &a = sim_.balls[low], &b = sim_.balls[high];
    Ball& sleeper = a.asleep ? a : b;
    const double mass = sleeper.mass;
    if (sleeper.asleep) sleeper.mass = INFINITY;
    const Impact impact = respond(a, b, sim_.layout.mixed(a, b), {.rest_speed = rest_speed});
    sleeper.mass = mass;
    if (!impact.happened) return false;
    ++sim_.record->statistics.impacts;
    if (is_significant(impact, a)) sim_.particles[low].idle_events = sim_.particles[high].idle_events = 0;
    report(time, EventKind::impact, a, Other::ball(b.number), impact, b.position + b.radius * impact.normal);
    if (!within_top_speed(b))
        refuse_speed(engine_name, b, Other::ball(a.number), sim_.start + time, sim_.scene);
    return true;
}

/// Wakes the sleeping balls that lie on a ball that has moved, and those that lie on them.
void Events::wake_carried(BallIndex i, double time) {
    woken_.assign(1, i);
    sim_.cells.flood_fill(woken_, [&](BallIndex k, BallIndex j) {
        const Ball& carrier = sim_.balls[k];
        Ball& ball = sim_.balls[j];
        if (!ball.asleep || !layers_meet(carrier, ball)) return;
        const Vec2 up = ball.position - sim_.particles[k].motion.path.position(time);
        const double reach = carrier.radius + ball.radius,
                     near = touch_distance * std::min(carrier.radius, ball.radius);
        if (length(up) > reach + near || !(dot(up, sim_.scene.gravity) < 0)) return;
        ball.asleep = false;
        woken_.push_back(j);
    });
    for (const BallIndex j : std::span(woken_).subspan(1)) {
        paths_.start_path(j, time);
        sim_.join_island(j, time);
    }
    for (const BallIndex j : std::span(woken_).subspan(1)) predictions_.predict(j, time);
}

void Events::lose(BallIndex i, double time) {
    Ball& ball = sim_.balls[i];
    const Vec2 p = sim_.particles[i].motion.path.position(time);
    report(time, EventKind::lost, ball, {}, {}, p);
    if (sim_.scene.keep_lost) {
        sim_.table.reported_lost().push_back(ball.number);
        return predictions_.predict(i, time);
    }
    sim_.hot[i].lost = true;
    sim_.leave_island(i);
    ++sim_.hot[i].version;
    sim_.cells.remove(i);
    predictions_.forget(i);
    std::erase_if(sim_.table.blocked(), [&](const Blocked& blocked) { return blocked.ball == ball.number; });
    while (!gates_.around(ball.number).empty())
        enter_or_leave(i, gates_.around(ball.number).front().part, time);
}

/// Handles a ball that enters or leaves a sensor, or leaves a gate.
void Events::enter_or_leave(BallIndex i, PartIndex part, double time) {
    const Ball& ball = sim_.balls[i];
    if (!sim_.scene.parts[part].sensor) return leave_gate(ball.number, part, time);
    const bool enters = !gates_.inside(ball.number, part);
    gates_.set_inside(ball.number, part, enters);
    const EventKind kind = enters ? EventKind::sensor_begin : EventKind::sensor_end;
    report(time, kind, ball, Other::part(part), {}, {});
}

/// Handles a ball that reaches a gate. Returns whether the gate lets it through; it is then open for all
/// balls.
bool Events::meet_gate(BallIndex i, PartIndex part, double time) {
    const Ball& ball = sim_.balls[i];
    if (!gates_.lets_through(part, ball, time)) {
        sim_.table.set_blocked(part, ball.number, true);
        return false;
    }
    gates_.set_inside(ball.number, part, true);
    if (sim_.table.parts()[part].open) return true;
    sim_.table.set_open(part, true);
    std::erase_if(sim_.table.blocked(), [&](const Blocked& blocked) {
        if (blocked.gate == part) gates_.set_inside(blocked.ball, part, true);
        return blocked.gate == part;
    });
    release(part, i, time);
    return true;
}

/// Handles a ball that has left a gate, whether the gate let it through or not.
void Events::leave_gate(BallNumber ball, PartIndex part, double time) {
    sim_.table.set_blocked(part, ball, false);
    if (!gates_.inside(ball, part)) return;
    gates_.set_inside(ball, part, false);
    if (gates_.any_inside(part)) return;
    sim_.table.set_open(part, false);
    // Predictions made while the gate was open no longer hold.
    for (BallIndex j = 0; j < sim_.particles.size(); ++j)
        if (sim_.balls[j].number != ball && !sim_.balls[j].asleep && !sim_.hot[j].lost)
            predictions_.predict(j, time);
}

}  // namespace flipside::custom
