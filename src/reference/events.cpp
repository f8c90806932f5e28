#include <algorithm>

#include "reference/simulation.hpp"
#include "world/limits.hpp"
#include "world/refusal.hpp"

namespace flipside::reference {

/// Moves a ball along its path to now.
template <class R>
void Simulation<R>::advance(Particle& particle) {
    const Motion<R> now = particle.path.at(now_);
    const Spinning<R> spinning = particle.path.spinning_at(now_);
    particle.body = {now.position, now.velocity, spinning.angle, spinning.spin, particle.radius};
    Path<R>& path = particle.path;
    path.position = particle.body.position;
    path.velocity = particle.body.velocity;
    path.angle = particle.body.angle;
    path.spin = particle.body.spin;
    path.start = now_;
    path.spin_rate = R(0);
    path.roll = {};
    path.is_series = path.rests = false;
}

template <class R>
void Simulation<R>::report(EventKind kind, const Particle& particle, Other other, const Impact<R>& impact,
                           const V<R>& point, const V<R>& normal) {
    if (kind == EventKind::impact) ++counts_.impacts;
    events_.push_back({static_cast<double>(now_ - run_start_), kind, particle.ball.number, other,
                       narrow(point), narrow(normal), static_cast<double>(impact.speed),
                       static_cast<double>(impact.impulse)});
}

/// Refuses series of events in which no time passes, and steps that take too long.
template <class R>
void Simulation<R>::refuse_endless(Particle& particle) {
    constexpr double instant = 1e-9;  // s; bounces that die away at e = 0.99 are 1,600 in the last of it
    constexpr int most = 2000;
    // A billiard that spells out pi has 314,159 collisions in a moment, each with about four searches. With
    // drag a search takes up to 10 µs, and up to 100 µs of the wider numbers: all of a step stay below some
    // seconds.
    constexpr bool is_wide = !std::is_same_v<R, double>;
    const bool drags = external_.drag > 0;
    const std::uint64_t most_searches = is_wide ? (drags ? 20'000 : 50'000) : (drags ? 200'000 : 2'000'000);
    const std::uint64_t per_ball = is_wide && drags ? 200 : 2'000;
    if (now_ - particle.series_since > instant) {
        particle.series_since = now_;
        particle.series_events = 0;
    }
    const bool too_many = counts_.narrow_tests > most_searches + per_ball * particles_.size();
    if (++particle.series_events <= most && !too_many) return;
    const std::string hit =
        particle.next == Next::feature ? scene_->parts[features_[particle.next_index].part].name
        : particle.next == Next::ball  ? "ball " + std::to_string(particles_[particle.next_index].ball.number)
                                       : "its own path";
    throw Refusal("reference: ball " + std::to_string(particle.ball.number) + " hits " + hit +
                  (too_many
                       ? " after too many searches in one step" + at_time(now_)
                       : " without end" + at_time(now_) + ": it is squeezed between parts or in a heap"));
}

/// Refuses a speed above the limit after an impact.
template <class R>
void Simulation<R>::require_speed(const Particle& particle, Other other) const {
    Ball ball = particle.ball;
    ball.velocity = narrow(particle.body.velocity);
    ball.spin = static_cast<double>(particle.body.spin);
    if (within_top_speed(ball)) return;
    refuse_speed("reference", ball, other, clock(now_), *scene_);
}

/// Handles the next event of a ball.
template <class R>
void Simulation<R>::handle(BallIndex i) {
    Particle& particle = particles_[i];
    refuse_endless(particle);
    switch (particle.next) {
        case Next::feature:
            if (ignores(features_[particle.next_index].part, particle)) return predict(i);
            return hit_feature(i);
        case Next::ball:
            if (particles_[particle.next_index].gone ||
                particles_[particle.next_index].changes != particle.other_version)
                return predict(i);
            return hit_ball(i);
        case Next::predict_again:
            // Only the horizon of the prediction was reached, or the ball rests in a heap by now.
            if (particle.next_index != 0 || particle.heap != 0) return predict(i);
            advance(particle);
            if (particle.separates) particle.left = particle.support[0];
            if (particle.support[1] != nothing) particle.body.spin = R(0);
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
void Simulation<R>::enter_cell(BallIndex i, Cells::Index cell) {
    Particle& particle = particles_[i];
    if (cell == particle.cell) return;
    cells_.unlink(i, particle.cell);
    particle.cell = cell;
    cells_.link(i, cell);
}

template <class R>
void Simulation<R>::cross_cell(BallIndex i) {
    const Particle& particle = particles_[i];
    enter_cell(i, cells_.beyond(particle.cell, static_cast<int>(particle.next_index)));
    predict(i);
}

template <class R>
void Simulation<R>::hit_feature(BallIndex i) {
    Particle& particle = particles_[i];
    const FeatureIndex f = particle.next_index;
    const PartIndex index = features_[f].part;
    const Part& part = scene_->parts[index];
    if (particle.heap != 0) refuse_impact_on_heap(particle, part.name);
    if (certificate_) note_impact(i);
    advance(particle);
    Body<R>& body = particle.body;
    const Closest<R> seen = closest(f, body.position, particle.radius);
    const Turning<R>* turns = turning(index);
    const V<R>& normal = seen.normal;
    if (gate_of(part) != nullptr && reach_gate(i, index)) return;
    const V<R> point = body.position - (seen.gap + particle.radius) * normal;
    const V<R> surface = turns == nullptr ? V<R>{} : cross(turns->rate, point - turns->pivot);
    const V<R> relative = body.velocity - surface;
    const R closing = -dot(relative, normal);
    // A slower approach is a sliding contact.
    if (closing <= 4096 * epsilon<R>() * (length(body.velocity) + length(relative))) {
        if (closing > 0) body.velocity += closing * normal;
    } else {
        const Mixed& material = mixed(particle.ball.material, part.material);
        const Impact<R> impact = respond(body, particle.mass, normal, surface, material, scene_->rest_speed);
        require_speed(particle, Other::part(index));
        if (impact.happened) report(EventKind::impact, particle, Other::part(index), impact, point, normal);
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
    const BallIndex j = particles_[i].next_index;
    Particle &a = particles_[std::min(i, j)], &b = particles_[std::max(i, j)];
    if (a.heap != 0) refuse_impact_on_heap(a, "ball " + std::to_string(b.ball.number));
    if (b.heap != 0) refuse_impact_on_heap(b, "ball " + std::to_string(a.ball.number));
    if (certificate_) note_impact(i);
    advance(a);
    advance(b);
    const V<R> between = a.body.position - b.body.position, normal = unit(between);
    const V<R> relative = a.body.velocity - b.body.velocity;
    const R closing = -dot(relative, normal);
    using std::sqrt;
    const R lowest_bounce = sqrt(2 * rounding_of(a.body) * length(external_.gravity));
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
void Simulation<R>::refuse_resting_contact(Particle& a, Particle& b) const {
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
    Particle& particle = particles_[i];
    const PartIndex part = particle.next_index;
    if (scene_->parts[part].sensor) {
        const auto at = std::ranges::find(particle.inside, part);
        const bool enters = at == particle.inside.end();
        if (enters)
            particle.inside.push_back(part);
        else
            particle.inside.erase(at);
        report(enters ? EventKind::sensor_begin : EventKind::sensor_end, particle, Other::part(part), {}, {},
               {});
    } else {
        leave_gate(particle, part);
    }
    predict(i);
}

template <class R>
void Simulation<R>::lose(BallIndex i) {
    Particle& particle = particles_[i];
    // The border is still inside: take the first point outside.
    Vec2 point = narrow(particle.path.at(now_).position);
    const Box& bounds = scene_->bounds;
    if (particle.next_index == 0) point.x = std::nextafter(bounds.min.x, -INFINITY);
    if (particle.next_index == 1) point.x = std::nextafter(bounds.max.x, INFINITY);
    if (particle.next_index == 2) point.y = std::nextafter(bounds.min.y, -INFINITY);
    if (particle.next_index == 3) point.y = std::nextafter(bounds.max.y, INFINITY);
    report(EventKind::lost, particle, {}, {}, V<R>(point), {});
    if (scene_->keep_lost) {
        particle.reported_lost = true;
        reported_lost_.push_back(particle.ball.number);
        return predict(i);
    }
    for (const PartIndex part : particle.inside)
        if (scene_->parts[part].sensor)
            report(EventKind::sensor_end, particle, Other::part(part), {}, {}, {});
    remove(particle.ball.number);
}

#define FLIPSIDE_EVENTS(R)                           \
    template void Simulation<R>::advance(Particle&); \
    template void Simulation<R>::handle(BallIndex);  \
    template void Simulation<R>::enter_cell(BallIndex, Cells::Index);
FLIPSIDE_EVENTS(double)
FLIPSIDE_EVENTS(Real113)
FLIPSIDE_EVENTS(Real226)
#undef FLIPSIDE_EVENTS

}  // namespace flipside::reference
