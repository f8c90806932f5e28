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
    path.is_series = path.rests = false;
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
void Simulation<R>::refuse_endless(Mover& mover) {
    constexpr double instant = 1e-9;  // s; bounces that die away at e = 0.99 are 1,600 in the last of it
    constexpr int most = 2000;
    // A billiard that spells out pi has 314,159 collisions in a moment, each with about four searches. Of the
    // wider numbers a search with drag takes up to 60 µs.
    constexpr std::uint64_t most_searches = std::is_same_v<R, double> ? 2'000'000 : 50'000, per_ball = 2'000;
    if (now_ - mover.series_since > instant) {
        mover.series_since = now_;
        mover.series_events = 0;
    }
    const bool too_many = counts_.narrow_tests > most_searches + per_ball * movers_.size();
    if (++mover.series_events <= most && !too_many) return;
    const std::string hit = mover.next == Next::feature ? scene_->parts[features_[mover.next_index].part].name
                            : mover.next == Next::ball
                                ? "ball " + std::to_string(movers_[mover.next_index].ball.number)
                                : "its own path";
    throw Refusal("reference: ball " + std::to_string(mover.ball.number) + " hits " + hit +
                  (too_many
                       ? " after too many searches in one step" + at_time(now_)
                       : " without end" + at_time(now_) + ": it is squeezed between parts or in a heap"));
}

/// Refuses a speed above the limit after an impact.
template <class R>
void Simulation<R>::require_speed(const Mover& mover, Other other) const {
    Ball ball = mover.ball;
    ball.velocity = narrow(mover.body.velocity);
    ball.spin = static_cast<double>(mover.body.spin);
    if (within_top_speed(ball)) return;
    refuse_speed("reference", ball, other, clock(now_), *scene_);
}

/// Handles the next event of a ball.
template <class R>
void Simulation<R>::handle(BallIndex i) {
    Mover& mover = movers_[i];
    refuse_endless(mover);
    switch (mover.next) {
        case Next::feature:
            if (ignores(features_[mover.next_index].part, mover)) return predict(i);
            return hit_feature(i);
        case Next::ball:
            if (movers_[mover.next_index].gone || movers_[mover.next_index].changes != mover.other_version)
                return predict(i);
            return hit_ball(i);
        case Next::predict_again:
            // Only the horizon of the prediction was reached, or the ball rests in a heap by now.
            if (mover.next_index != 0 || mover.heap != 0) return predict(i);
            advance(mover);
            if (mover.separates) mover.left = mover.support[0];
            if (mover.support[1] != nothing) mover.body.spin = R(0);
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
void Simulation<R>::cross_cell(BallIndex i) {
    Mover& mover = movers_[i];
    cells_.unlink(i, mover.cell);
    mover.cell = cells_.beyond(mover.cell, static_cast<int>(mover.next_index));
    cells_.link(i, mover.cell);
    predict(i);
}

template <class R>
void Simulation<R>::hit_feature(BallIndex i) {
    Mover& mover = movers_[i];
    const FeatureIndex f = mover.next_index;
    const PartIndex index = features_[f].part;
    const Part& part = scene_->parts[index];
    if (mover.heap != 0) refuse_impact_on_heap(mover, part.name);
    if (certificate_) note_impact(i);
    advance(mover);
    Body<R>& body = mover.body;
    const Closest<R> seen = closest(f, body.position, mover.radius);
    const Turning<R>* turns = turning(index);
    const V<R>& normal = seen.normal;
    if (gate_of(part) != nullptr && reach_gate(i, index)) return;
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
void Simulation<R>::hit_ball(BallIndex i) {
    const BallIndex j = movers_[i].next_index;
    Mover &a = movers_[std::min(i, j)], &b = movers_[std::max(i, j)];
    if (a.heap != 0) refuse_impact_on_heap(a, "ball " + std::to_string(b.ball.number));
    if (b.heap != 0) refuse_impact_on_heap(b, "ball " + std::to_string(a.ball.number));
    if (certificate_) note_impact(i);
    advance(a);
    advance(b);
    const V<R> between = a.body.position - b.body.position, normal = unit(between);
    const V<R> relative = a.body.velocity - b.body.velocity;
    const R closing = -dot(relative, normal);
    using std::sqrt;
    const R lowest_bounce = sqrt(2 * epsilon<R>() * std::min(a.radius, b.radius) * length(external_.gravity));
    bool slow = true;
    if (closing > 4096 * epsilon<R>() * (length(a.body.velocity) + length(b.body.velocity))) {
        const Mixed& material = mixed(a.ball.material, b.ball.material);
        const Impact<R> impact =
            respond(a.body, a.mass, b.body, b.mass, normal, material, scene_->rest_speed);
        require_speed(a, Other::ball(b.ball.number));
        require_speed(b, Other::ball(a.ball.number));
        slow = !impact.happened || impact.speed <= lowest_bounce;
        if (impact.happened)
            report(EventKind::impact, a, Other::ball(b.ball.number), impact,
                   b.body.position + b.radius * normal, normal);
    }
    start_path(i);
    start_path(j);
    if (slow && a.heap == 0) refuse_resting_contact(a, b);
    predict(i);
    predict(j);
}

/// Whether two balls are in resting contact: they touch, do not separate, and accelerate towards each other;
/// or a third ball drives them together, with slow contacts that alternate without end.
template <class R>
void Simulation<R>::refuse_resting_contact(Mover& a, Mover& b) const {
    constexpr double moment = 1e-4;  // s
    constexpr int most = 60;
    const auto refuse = [&] {
        throw Refusal("reference: balls " + std::to_string(a.ball.number) + " and " +
                      std::to_string(b.ball.number) + " are in resting contact" + at_time(now_) +
                      ": resting contact between balls has no order of impacts" +
                      (now_ - a.no_equilibrium_since <= moment ? a.no_equilibrium : ""));
    };
    if (now_ - a.slow_contacts_since > moment) {
        a.slow_contacts_since = now_;
        a.slow_contacts = 0;
    }
    if (++a.slow_contacts > most) refuse();
    const V<R> between = a.body.position - b.body.position, normal = unit(between);
    const V<R> relative = a.path.velocity - b.path.velocity;
    const R apart = dot(relative, normal), across = dot(relative, perp(normal));
    const R speed = length(a.path.velocity) + length(b.path.velocity);
    if (magnitude(apart) > 4096 * epsilon<R>() * speed) return;
    const R toward =
        dot(a.path.begins_with() - b.path.begins_with(), normal) + across * across / (a.radius + b.radius);
    const R scale = length(external_.gravity) + length(a.path.begins_with()) + length(b.path.begins_with());
    if (toward >= -4096 * epsilon<R>() * scale) return;
    refuse();
}

/// Handles a ball that enters or leaves a sensor, or leaves a gate.
template <class R>
void Simulation<R>::sense(BallIndex i) {
    Mover& mover = movers_[i];
    const PartIndex part = mover.next_index;
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
void Simulation<R>::lose(BallIndex i) {
    Mover& mover = movers_[i];
    // The border is still inside: take the first point outside.
    Vec2 point = narrow(mover.path.at(now_).position);
    const Box& bounds = scene_->bounds;
    if (mover.next_index == 0) point.x = std::nextafter(bounds.min.x, -INFINITY);
    if (mover.next_index == 1) point.x = std::nextafter(bounds.max.x, INFINITY);
    if (mover.next_index == 2) point.y = std::nextafter(bounds.min.y, -INFINITY);
    if (mover.next_index == 3) point.y = std::nextafter(bounds.max.y, INFINITY);
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
    template void Simulation<R>::handle(BallIndex);
FLIPSIDE_EVENTS(double)
FLIPSIDE_EVENTS(Real113)
FLIPSIDE_EVENTS(Real226)
#undef FLIPSIDE_EVENTS

}  // namespace flipside::reference
