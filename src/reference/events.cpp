#include <algorithm>

#include "reference/simulation.hpp"
#include "world/limits.hpp"
#include "world/refusal.hpp"

namespace flipside::reference {

/// Moves a ball along its path to now.
template <class R>
void Simulation<R>::advance(Mover& mover) {
    const Motion<R> now = mover.path.at(now_);
    const Spinning<R> spinning = mover.path.spinning_at(now_);
    mover.body = {now.position, now.velocity, spinning.angle, spinning.spin, mover.radius};
    Path<R>& path = mover.path;
    path.position = mover.body.position;
    path.velocity = mover.body.velocity;
    path.angle = mover.body.angle;
    path.spin = mover.body.spin;
    path.start = now_;
    path.spin_rate = R(0);
    path.roll = {};
    path.rides = path.rests = false;
}

template <class R>
void Simulation<R>::report(EventKind kind, const Mover& mover, Other other, const Impact<R>& impact,
                           const V<R>& point, const V<R>& normal) {
    if (kind == EventKind::impact) ++counts_.impacts;
    events_.push_back({static_cast<double>(now_ - run_start_), kind, mover.ball.number, other, narrow(point),
                       narrow(normal), static_cast<double>(impact.speed),
                       static_cast<double>(impact.impulse)});
}

/// Refuses series of events in which no time passes, and steps that take too long.
template <class R>
void Simulation<R>::keep_order(Mover& mover) {
    constexpr double instant = 1e-9;  // s; bounces that die away at e = 0.99 are 1,600 in the last of it
    constexpr int most = 2000;
    // A billiard that spells out pi has 314,159 collisions in a moment, each with about four searches. Of the
    // wider numbers a search with drag takes up to 60 µs.
    constexpr std::uint64_t most_searches = std::is_same_v<R, double> ? 2'000'000 : 50'000, per_ball = 2'000;
    if (now_ - mover.busy_since > instant) {
        mover.busy_since = now_;
        mover.busy = 0;
    }
    const bool too_many = counts_.narrow_tests > most_searches + per_ball * movers_.size();
    if (++mover.busy <= most && !too_many) return;
    const std::string met = mover.next == Next::feature ? scene_->parts[features_[mover.met].part].name
                            : mover.next == Next::ball
                                ? "ball " + std::to_string(movers_[mover.met].ball.number)
                                : "its own path";
    throw Refusal("reference: ball " + std::to_string(mover.ball.number) + " meets " + met +
                  (too_many ? " after too many searches in one step" + at_time(now_)
                            : " without end" + at_time(now_) + ": it is squeezed or in a pile"));
}

/// Notes an impact.
template <class R>
void Simulation<R>::require_speed(const Mover& mover, Other met) const {
    Ball ball = mover.ball;
    ball.velocity = narrow(mover.body.velocity);
    ball.spin = static_cast<double>(mover.body.spin);
    if (within_top_speed(ball)) return;
    refuse_speed("reference", ball, met, clock(now_), *scene_);
}

/// Handles the next event of a ball.
template <class R>
void Simulation<R>::handle(Place i) {
    Mover& mover = movers_[i];
    keep_order(mover);
    switch (mover.next) {
        case Next::feature:
            if (ignores(features_[mover.met].part, mover)) return predict(i);
            return hit_feature(i);
        case Next::ball:
            if (movers_[mover.met].gone || movers_[mover.met].changes != mover.met_changes) return predict(i);
            return hit_ball(i);
        case Next::look_again:
            // Only the horizon of the prediction was reached, or the ball rests in a heap by now.
            if (mover.met != 0 || mover.heap != 0) return predict(i);
            advance(mover);
            if (mover.separates) mover.left = mover.held[0];
            if (mover.held[1] != nothing) mover.body.spin = R(0);
            start_path(i);
            return predict(i);
        case Next::cell:
            return cross_cell(i);
        case Next::sensor:
            return sense(i);
        case Next::lost:
            return lose(i);
        case Next::nothing:
            return;
    }
}

template <class R>
void Simulation<R>::cross_cell(Place i) {
    Mover& mover = movers_[i];
    cells_.unlink(i, mover.cell);
    mover.cell = cells_.beyond(mover.cell, static_cast<int>(mover.met));
    cells_.link(i, mover.cell);
    predict(i);
}

template <class R>
void Simulation<R>::hit_feature(Place i) {
    Mover& mover = movers_[i];
    const FeatureIndex f = mover.met;
    const PartIndex index = features_[f].part;
    const Part& part = scene_->parts[index];
    if (mover.heap != 0) refuse_hit(mover, part.name);
    if (certificate_) note_meeting(i);
    advance(mover);
    Body<R>& body = mover.body;
    const Closest<R> seen = closest(f, body.position, mover.radius);
    const Turning<R>* turns = turning(index);
    const V<R>& normal = seen.normal;
    if (gate_of(part) != nullptr && meet_gate(i, index)) return;
    const V<R> point = body.position - (seen.gap + mover.radius) * normal;
    const V<R> surface = turns == nullptr ? V<R>{} : cross(turns->rate, point - turns->pivot);
    const V<R> relative = body.velocity - surface;
    const R closing = -dot(relative, normal);
    // A slower approach is a sliding contact.
    if (closing <= 4096 * epsilon<R>() * (length(body.velocity) + length(relative))) {
        if (closing > 0) body.velocity += closing * normal;
    } else {
        const Mixed& material = mixed(mover.ball.material, part.material);
        const Impact<R> impact = respond(body, mover.mass, normal, surface, material, scene_->rest_speed);
        require_speed(mover, Other::part(index));
        if (impact.happened) report(EventKind::impact, mover, Other::part(index), impact, point, normal);
        if (impact.happened && part.target) {
            parts_[index].down = true;
            if (certificate_) note_target(index);
        }
    }
    start_path(i);
    predict(i);
    if (parts_[index].down) release(index);
}

template <class R>
void Simulation<R>::hit_ball(Place i) {
    const Place j = movers_[i].met;
    Mover &a = movers_[std::min(i, j)], &b = movers_[std::max(i, j)];
    if (a.heap != 0) refuse_hit(a, "ball " + std::to_string(b.ball.number));
    if (b.heap != 0) refuse_hit(b, "ball " + std::to_string(a.ball.number));
    if (certificate_) note_meeting(i);
    advance(a);
    advance(b);
    const V<R> between = a.body.position - b.body.position, normal = unit(between);
    const V<R> relative = a.body.velocity - b.body.velocity;
    const R closing = -dot(relative, normal);
    using std::sqrt;
    const R hop = sqrt(2 * epsilon<R>() * std::min(a.radius, b.radius) * length(drive_.gravity));
    bool slow = true;
    if (closing > 4096 * epsilon<R>() * (length(a.body.velocity) + length(b.body.velocity))) {
        const Mixed& material = mixed(a.ball.material, b.ball.material);
        const Impact<R> impact =
            respond(a.body, a.mass, b.body, b.mass, normal, material, scene_->rest_speed);
        require_speed(a, Other::ball(b.ball.number));
        require_speed(b, Other::ball(a.ball.number));
        slow = !impact.happened || impact.speed <= hop;
        if (impact.happened)
            report(EventKind::impact, a, Other::ball(b.ball.number), impact,
                   b.body.position + b.radius * normal, normal);
    }
    start_path(i);
    start_path(j);
    if (slow && a.heap == 0) refuse_piles(a, b);
    predict(i);
    predict(j);
}

/// Whether two balls are in resting contact: they touch, do not separate, and accelerate towards each other;
/// or a third ball drives them together, with slow contacts that alternate without end.
template <class R>
void Simulation<R>::refuse_piles(Mover& a, Mover& b) const {
    constexpr double moment = 1e-4;  // s
    constexpr int most = 60;
    const auto refuse = [&] {
        throw Refusal("reference: balls " + std::to_string(a.ball.number) + " and " +
                      std::to_string(b.ball.number) + " press on each other" + at_time(now_) +
                      ": a pile has no order of impacts" + (now_ - a.unheld_since <= moment ? a.unheld : ""));
    };
    if (now_ - a.pressed_since > moment) {
        a.pressed_since = now_;
        a.pressed = 0;
    }
    if (++a.pressed > most) refuse();
    const V<R> between = a.body.position - b.body.position, normal = unit(between);
    const V<R> relative = a.path.velocity - b.path.velocity;
    const R apart = dot(relative, normal), across = dot(relative, perp(normal));
    const R speed = length(a.path.velocity) + length(b.path.velocity);
    if (magnitude(apart) > 4096 * epsilon<R>() * speed) return;
    const R pulled =
        dot(a.path.begins_with() - b.path.begins_with(), normal) + across * across / (a.radius + b.radius);
    const R scale = length(drive_.gravity) + length(a.path.begins_with()) + length(b.path.begins_with());
    if (pulled >= -4096 * epsilon<R>() * scale) return;
    refuse();
}

/// Handles a ball that enters or leaves a sensor, or leaves a gate.
template <class R>
void Simulation<R>::sense(Place i) {
    Mover& mover = movers_[i];
    const PartIndex part = mover.met;
    if (scene_->parts[part].sensor) {
        const auto at = std::ranges::find(mover.inside, part);
        const bool enters = at == mover.inside.end();
        if (enters)
            mover.inside.push_back(part);
        else
            mover.inside.erase(at);
        report(enters ? EventKind::sensor_begin : EventKind::sensor_end, mover, Other::part(part), {}, {},
               {});
    } else {
        leave_gate(mover, part);
    }
    predict(i);
}

template <class R>
void Simulation<R>::lose(Place i) {
    Mover& mover = movers_[i];
    // The border is still inside: take the first point outside.
    Vec2 point = narrow(mover.path.at(now_).position);
    const Box& bounds = scene_->bounds;
    if (mover.met == 0) point.x = std::nextafter(bounds.min.x, -INFINITY);
    if (mover.met == 1) point.x = std::nextafter(bounds.max.x, INFINITY);
    if (mover.met == 2) point.y = std::nextafter(bounds.min.y, -INFINITY);
    if (mover.met == 3) point.y = std::nextafter(bounds.max.y, INFINITY);
    report(EventKind::lost, mover, {}, {}, V<R>(point), {});
    if (scene_->keep_lost) {
        mover.reported_lost = true;
        reported_lost_.push_back(mover.ball.number);
        return predict(i);
    }
    for (const PartIndex part : mover.inside)
        if (scene_->parts[part].sensor) report(EventKind::sensor_end, mover, Other::part(part), {}, {}, {});
    remove(mover.ball.number);
}

#define FLIPSIDE_EVENTS(R)                        \
    template void Simulation<R>::advance(Mover&); \
    template void Simulation<R>::handle(Place);
FLIPSIDE_EVENTS(double)
FLIPSIDE_EVENTS(Real113)
FLIPSIDE_EVENTS(Real226)
#undef FLIPSIDE_EVENTS

}  // namespace flipside::reference
