#include "custom/continuous/next_events.hpp"

#include <algorithm>
#include <cmath>

#include "custom/tolerances.hpp"

namespace flipside::custom {

namespace {

/// Radii: a member that moves farther than this along a part in a tick does not rest on it. The chord of a
/// slower one enters an arc of at least twice its own radius by at most farthest_chord²/8 = 0.00125 radii.
constexpr double farthest_chord = 0.1;
/// Radii of the smaller one: two members that move farther past each other in a tick have exact impacts. The
/// direction of their contact turns by up to 0.2 rad in the tick, which the contact solver ignores.
constexpr double farthest_slide = 0.4;

}  // namespace

void Predictions::enter_cell(BallIndex i) {
    const double time = sim_.particles[i].cell_exit;
    const Cells::Cell before = sim_.cells[i];
    const Flight::Motion here = sim_.particles[i].motion.path.at(time);
    sim_.cells.insert(i, before.level, here.position);
    paths_.update_swept_bounds(i, time, here);
    if (sim_.particles[i].cell_exit <= time) sim_.particles[i].cell_exit = never_touch;
    ++batch_;
    predict_loss(i, time);
    sim_.cells.query_new_neighbours(i, before, [&](BallIndex j) { predict_ball(i, j, time); });
    predict_features(i, time, here.position);
    schedule(i);
}

void Predictions::offer(BallIndex i, double time, EventType next, std::uint32_t partner,
                        std::uint32_t partner_version) const {
    Particle& particle = sim_.particles[i];
    if (!(time <= particle.next_time)) return;
    if (time == particle.next_time &&
        order_of(i, next, partner) >= order_of(i, particle.next, particle.partner))
        return;
    particle.next_time = time;
    particle.next = next;
    particle.partner = partner;
    particle.partner_version = partner_version;
}

std::uint64_t Predictions::order_of(BallIndex i, EventType next, std::uint32_t partner) {
    constexpr std::uint64_t meets_ball = std::uint64_t{1} << 63;
    if (next != EventType::ball) return std::uint64_t{i} << 32;
    return meets_ball | std::uint64_t{std::min(i, partner)} << 32 | std::max(i, partner);
}

void Predictions::predict(std::span<const BallIndex> balls, double time) {
    ++batch_;
    for (const BallIndex i : balls) sim_.near[i] = {};
    for (const BallIndex i : balls) predict_in_batch(i, time);
}

void Predictions::predict_in_batch(BallIndex i, double time) {
    Particle& particle = sim_.particles[i];
    particle.next = EventType::none;
    particle.next_time = sim_.after_end;
    if (particle.frozen) sim_.near[i] = {INFINITY, -INFINITY, true};  // nothing is predicted of it
    if (sim_.hot[i].lost || sim_.balls[i].asleep || particle.frozen) return forget(i);
    if (!particle.on_tick_path) offer(i, particle.motion.until, EventType::path_end);
    predict_loss(i, time);
    sim_.hot[i].batch = batch_;
    sim_.cells.query_neighbours(i, [&](BallIndex j) { predict_ball(i, j, time); });
    const Path& path = particle.motion.path;
    predict_features(i, time, time == path.start ? path.flight.position : path.position(time));
    schedule(i);
}

double Predictions::search_end(const Particle& particle) const {
    return std::min({sim_.end, particle.motion.until, particle.cell_exit, particle.next_time});
}

void Predictions::schedule(BallIndex i) {
    const Particle& particle = sim_.particles[i];
    if (particle.cell_exit <= particle.next_time)
        return queue_.set(i, particle.cell_exit, std::uint64_t{i} << 32);
    queue_.set(i, particle.next_time, order_of(i, particle.next, particle.partner));
}

/// Whether the ball reaches this feature only by sliding to the end of the face on which it rests. That is no
/// impact, but an overlap of one rounding u would look like one, at an angle of √u.
bool Predictions::slides_to(const Particle& particle, const Ball& ball, const Feature& feature) const {
    if (particle.resting_on == nullptr) return false;
    const PartIndex part = feature.part, own = particle.resting_on->part;
    const Turning& turning = sim_.turnings[own];
    if (part != own && !(turning.unmoved() && sim_.turnings[part].unmoved())) return false;
    const Pose pose = turning.pose(particle.motion.path.start);
    const Vec2 normal = closest_point(*particle.resting_on, pose.undo(ball.position), ball.radius).normal;
    return continues_in(*particle.resting_on, normal, feature);
}

void Predictions::predict_features(BallIndex i, double time, Vec2 from) {
    Particle& particle = sim_.particles[i];
    sim_.near[i].part = particle.resting_on != nullptr;
    const std::span<const FeatureIndex> near = sim_.features_near(particle.bounds);
    bool may_sense = gates_.any_inside() || !sim_.table.blocked().empty();
    if (near.empty() && !may_sense) return;
    const Ball& ball = sim_.balls[i];
    const Path& path = particle.motion.path;
    const double end = std::min({sim_.end, particle.motion.until, particle.cell_exit}), duration = end - time;
    const Vec2 to = path.position(end);
    // Bound on the distance of the path from its chord. Features beyond the margin have no contact.
    const double margin = near_margin * ball.radius + joint_distance +
                          1e-12 * (std::abs(ball.position.x) + std::abs(ball.position.y));
    const double sag = path.max_acceleration(end) * duration * duration / 8 + margin;
    for (const FeatureIndex f : near) {
        const Feature& feature = sim_.features[f];
        const Turning& turning = sim_.turnings[feature.part];
        if (turning.unmoved() && !ball.asleep && clear_of(feature, from, to, ball.radius, sag)) continue;
        may_sense = may_sense || feature.sensor;
        if (&feature == particle.resting_on || gates_.ignores(feature, ball)) continue;
        sim_.near[i].part = true;
        if (slides_to(particle, ball, feature)) continue;
        if (sim_.hot[i].in_island && rests_on(i, feature, turning.pose(time), time)) continue;
        if (turning.rate_at(time) == 0 && particle.tangent_faces.above(feature, turning.pose(time))) continue;
        ++sim_.record->statistics.narrow_tests;
        offer(i,
              time_of_impact(feature, turning, path, ball.radius, time, search_end(particle),
                             sim_.search_steps),
              EventType::feature, f);
    }
    if (may_sense) predict_sensors(i, time, near);
}

/// Predicts when a ball enters or leaves a sensor, or leaves a gate.
void Predictions::predict_sensors(BallIndex i, double time, std::span<const FeatureIndex> near) {
    const Ball& ball = sim_.balls[i];
    const Particle& particle = sim_.particles[i];
    const auto predict_sensor = [&](PartIndex part, bool inside) {
        offer(i, gates_.sense_time(part, ball, particle.motion.path, time, search_end(particle), inside),
              EventType::sensor, part);
    };
    for (const Sensed& around : gates_.around(ball.number)) predict_sensor(around.part, true);
    for (const Blocked& blocked : sim_.table.blocked())
        if (blocked.ball == ball.number) predict_sensor(blocked.gate, true);
    PartIndex sensed = ~0U;
    for (const FeatureIndex f : near) {
        const Feature& feature = sim_.features[f];
        if (!feature.sensor || feature.part == sensed || !layers_meet(ball, feature) ||
            gates_.inside(ball.number, feature.part))
            continue;
        sensed = feature.part;
        predict_sensor(sensed, false);
    }
}

/// Predicts the impact of two balls, unless the other has been predicted in this batch. The result does not
/// depend on which of them is predicted, nor when.
void Predictions::predict_ball(BallIndex i, BallIndex j, double time) {
    const HotState &a = sim_.hot[i], &b = sim_.hot[j];
    if (b.batch == batch_) return;
    ++sim_.record->statistics.pair_tests;
    if (a.ballistic && b.ballistic) return predict_flying(i, j, time);
    if (!layers_meet(sim_.balls[i], sim_.balls[j])) return;
    note_near(i, j, -INFINITY, -INFINITY);  // at any time
    if (a.creeps && (b.creeps || sim_.balls[j].asleep)) return;
    if (a.in_island && (b.in_island || sim_.balls[j].asleep) && in_slow_contact(i, j, time)) return;
    const Particle &particle = sim_.particles[i], &other = sim_.particles[j];
    const double from = std::max(a.start, b.start);
    const double until = std::min({sim_.end, particle.motion.until, other.motion.until});
    if (until < from) return;
    ++sim_.record->statistics.narrow_tests;
    const double met = time_of_impact(particle.motion.path, other.motion.path, a.radius + b.radius, from,
                                      until, sim_.search_steps);
    offer(i, std::max(met, time), EventType::ball, j, b.version);
}

/// The same for two balls in ballistic flight. Their relative motion is straight.
void Predictions::predict_flying(BallIndex i, BallIndex j, double time) {
    const HotState &a = sim_.hot[i], &b = sim_.hot[j];
    const double from = std::max(a.start, b.start);
    const auto [p, v] = sim_.flying_at(a, from);
    const auto [q, u] = sim_.flying_at(b, from);
    const Vec2 between = p - q, relative = v - u;
    const double approach = -dot(between, relative);
    // Most pairs separate, or pass each other at a distance: they are rejected without a square root.
    constexpr double sure = 1e-9;  // greater than all rounding here
    const double reach = a.radius + b.radius, wide = (1 + near_margin) * reach;
    const double apart = length_squared(between) - wide * wide;
    if (apart > 0 && !(approach > 0)) return;
    if (apart > 0 && approach * approach * (1 + sure) < length_squared(relative) * apart) return;
    if (!(approach > 0)) {
        const double left = approach < 0 ? (1 + sure) * apart / (2 * approach) : INFINITY;
        return note_near(i, j, from + drag_time(sim_.external.drag, left), INFINITY);
    }
    const double soonest = from + (1 - sure) * std::max(apart, 0.0) / (2 * approach);
    note_near(i, j, -INFINITY, soonest);
    if (soonest > sim_.particles[i].next_time) return;
    if (a.in_island && b.in_island && approach <= sim_.slow * length(between)) return;
    if (!layers_meet(sim_.balls[i], sim_.balls[j])) return;
    ++sim_.record->statistics.narrow_tests;
    const double e = straight_touch(between, relative, reach, gap_rounding(p, q, reach));
    const double met = from + drag_time(sim_.external.drag, e);
    if (met <= std::min(sim_.particles[i].motion.until, sim_.particles[j].motion.until))
        offer(i, std::max(met, time), EventType::ball, j, b.version);
}

/// Notes that two balls may be within sleep_distance of each other until one time, and from another on.
void Predictions::note_near(BallIndex i, BallIndex j, double until, double from) {
    for (NearTimes* near : {&sim_.near[i], &sim_.near[j]}) {
        near->until = std::max(near->until, until);
        near->from = std::min(near->from, from);
    }
}

/// Predicts when the centre of the ball leaves the bounds of the scene.
void Predictions::predict_loss(BallIndex i, double time) {
    const Ball& ball = sim_.balls[i];
    Particle& particle = sim_.particles[i];
    const Box& bounds = sim_.scene.bounds;
    if (bounds.contains(particle.bounds.min) && bounds.contains(particle.bounds.max)) return;
    const auto& reported = sim_.table.reported_lost();
    if (std::ranges::find(reported, ball.number) != reported.end()) return;
    offer(i, first_exit(particle.motion.path, bounds, time, search_end(particle)), EventType::leave_bounds);
}

/// Whether two members approach and pass each other no faster than in a resting contact.
bool Predictions::in_slow_contact(BallIndex i, BallIndex j, double time) const {
    const auto a = sim_.particles[i].motion.path.at(time), b = sim_.particles[j].motion.path.at(time);
    const Vec2 between = a.position - b.position, relative = a.velocity - b.velocity;
    const double farthest = farthest_slide * std::min(sim_.balls[i].radius, sim_.balls[j].radius);
    return length(relative) * sim_.tick_length <= farthest && -dot(relative, unit(between)) <= sim_.slow;
}

/// The same for a member and a feature. A ball that joined since the last tick is still on its old path,
/// which could take it into the part before the next tick: for it the limit is rest_speed.
bool Predictions::rests_on(BallIndex i, const Feature& feature, const Pose& pose, double time) const {
    const auto here = sim_.particles[i].motion.path.at(time);
    const auto [distance, normal, facing] = closest_point(feature, here.position, sim_.balls[i].radius, pose);
    const Vec2 point = here.position - distance * normal;
    const Vec2 relative = here.velocity - sim_.turnings[feature.part].velocity_at(point, time);
    const double closing = -dot(relative, normal);
    if (sim_.hot[i].creeps) return sim_.creeps_at(closing, sim_.balls[i]);
    if (length(relative) * sim_.tick_length > farthest_chord * sim_.balls[i].radius) return false;
    return closing <= (sim_.particles[i].on_tick_path ? sim_.slow : sim_.scene.rest_speed);
}

}  // namespace flipside::custom
