#include "custom/continuous/paths.hpp"

#include <algorithm>

#include "custom/broad_phase/capacity.hpp"
#include "custom/geometry/narrow_phase.hpp"
#include "custom/response.hpp"

namespace flipside::custom {

namespace {

/// A bounce that would last less than this, in units of √(r/a), becomes a resting contact.
constexpr double shortest_bounce = 1e-9;
/// Two faces meet smoothly if the cosine of the angle between their normals is at least this (1.4e-3 rad; see
/// joint_angle).
constexpr double smooth_joint = 1 - 1e-6;
/// Speed, m/s, below which bounces on a feature that is curved or turns never end: the search finds an impact
/// late by a gap of up to `rounding`, and the speed gained over that gap is as large as the speed lost in the
/// bounce.
double unending_bounce(const Feature& feature, bool turns, double force, double rounding,
                       double restitution) {
    if ((std::holds_alternative<Line>(feature.is) && !turns) || restitution >= 1) return 0;
    return restitution * std::sqrt(2 * force * rounding / (1 - restitution * restitution));
}

/// Error of the direction of a straight face due to the rounding of its ends, rad.
double direction_rounding(const Feature& feature) {
    const auto* line = std::get_if<Line>(&feature.is);
    if (line == nullptr) return 0;
    return 16 * 0x1p-53 * (std::abs(line->start.x) + std::abs(line->start.y)) / line->length;
}

/// Unit vector in which the ball moves along a support: that of its velocity, or of the force if it is at
/// rest.
Vec2 direction_on(const RestingContact& support, const Ball& ball) {
    const Vec2 tangent = perp(support.normal);
    const double along = dot(ball.velocity - support.surface_velocity, tangent);
    return (along != 0 ? along : support.tangential) > 0 ? tangent : -tangent;
}

/// Whether, of two faces that meet smoothly, this one supports the ball. Forces do not decide this, since a
/// curve needs a greater one. The face that does not lead into the other does; if both or neither do, the
/// longer one.
bool takes_precedence(const RestingContact& support, const RestingContact& other, const Ball& ball,
                      double time) {
    const auto leads_into = [&](const RestingContact& from, const RestingContact& to) {
        return dot(direction_on(from, ball), to.normal) < -speed_rounding / 2;
    };
    if (leads_into(support, other) != leads_into(other, support)) return leads_into(other, support);
    const auto distance_left = [&](const RestingContact& on) {
        const Pose pose = on.turning->pose(time);
        return distance_to_end(*on.feature, pose.undo(ball.position),
                               rotated(direction_on(on, ball), -pose.angle), ball.radius);
    };
    const double left = distance_left(support), other_left = distance_left(other);
    return left > other_left || (left == other_left && &support < &other);
}

/// Whether one support carries the ball alone: its normal force and friction keep the ball off all others.
bool supports_alone(const RestingContact& support, std::span<const RestingContact> all, const Ball& ball,
                    double time) {
    const Vec2 motion = support.force * support.normal + friction_of(support, ball) * perp(support.normal);
    return std::ranges::all_of(all, [&](const RestingContact& other) {
        if (&other == &support) return true;
        if (dot(other.normal, support.normal) >= smooth_joint)
            return takes_precedence(support, other, ball, time);
        return other.force - dot(motion, other.normal) <= 1e-9 * support.force;
    });
}

}  // namespace

Paths::Paths(Simulation& sim, Gates& gates) : sim_(sim), gates_(gates) {
    supports_.reserve(std::min(sim.features.size(), most_near));
}

void Paths::push_out_of_parts(BallIndex i) {
    Ball& ball = sim_.balls[i];
    for (int round = 0; round < 4; ++round) {
        const double allowed = -deep_overlap * ball.radius;
        Touch deepest{{}, {}, allowed, false};
        const Box here = bounds_of(ball.position, ball.radius);
        for (const PrimitiveIndex near : gates_.primitives_near(here, ball)) {
            const Primitive& primitive = sim_.layout.primitive(near);
            if (gate_of(sim_.scene.parts[primitive.part]) != nullptr &&
                gates_.lets_through(primitive.part, ball, 0))
                continue;
            const Touch found =
                touch(ball.position, ball.radius, primitive, sim_.turnings[primitive.part].pose(0));
            if (found.past_end || found.separation >= deepest.separation) continue;
            if (!pushes_through(primitive.part, ball, found)) deepest = found;
        }
        if (deepest.separation == allowed) return;
        push_out(ball, deepest);
    }
}

/// Whether a moving part, or a target that was raised, that overlaps a ball would push it through another
/// part, against which it presses the ball. Such a ball is left where it is.
bool Paths::pushes_through(PartIndex by, const Ball& ball, const Touch& touch) {
    if (const Part& part = sim_.scene.parts[by]; !Table::moves(part) && !part.target) return false;
    const Vec2 from = ball.position, to = from - touch.separation * touch.normal;
    const Box pushed = united(bounds_of(from, 0), bounds_of(to, 0));
    const std::span<const FeatureIndex> near = sim_.ranges.near(pushed);
    sim_.record->statistics.pair_tests += near.size();
    return std::ranges::any_of(near, [&](FeatureIndex f) {
        if (!overlap(pushed, sim_.ranges[f])) return false;
        const Feature& feature = sim_.features[f];
        if (feature.part == by || feature.gate || gates_.ignores(feature, ball)) return false;
        const Pose pose = sim_.turnings[feature.part].pose(0);
        return crosses(feature, pose.undo(from), pose.undo(to));
    });
}

void Paths::start_path(BallIndex i, double time) {
    Ball& ball = sim_.balls[i];
    Particle& particle = sim_.particles[i];
    particle.on_tick_path = particle.frozen = sim_.hot[i].creeps = false;
    const Box here = bounds_of(ball.position, ball.radius * (1 + touch_distance));
    const auto moves = [&](FeatureIndex f) { return !sim_.turnings[sim_.features[f].part].still(); };
    if (ball.asleep && std::ranges::any_of(sim_.features_near(here), moves)) ball.asleep = false;
    const ExternalForces forces = ball.asleep ? ExternalForces{} : sim_.external;
    start_flight(i, {ball.position, ball.velocity, forces.gravity, forces.drag}, time);
    if (ball.asleep) return;
    find_supports(i, time);
    if (supports_.empty()) return;
    choose_support(i, time);
    sim_.hot[i].ballistic = particle.resting_on == nullptr;
    if (sim_.hot[i].ballistic) return note_tangent_faces(particle);
    list_in_cell(i, time);
}

void Paths::start_flight(BallIndex i, const Flight& flight, double time) {
    Particle& particle = sim_.particles[i];
    particle.resting_on = nullptr;
    particle.tangent_faces.clear();
    particle.motion.fly(flight, time);
    HotState& hot = sim_.hot[i];
    ++hot.version;
    sim_.balls[i].position = hot.position = flight.position;
    sim_.balls[i].velocity = hot.velocity = flight.velocity;
    hot.start = time;
    hot.ballistic = !sim_.balls[i].asleep && flight.acceleration == sim_.external.gravity &&
                    flight.drag == sim_.external.drag;
    list_in_cell(i, time);
}

void Paths::list_in_cell(BallIndex i, double time) {
    const Ball& ball = sim_.balls[i];
    const Path& path = sim_.particles[i].motion.path;
    constexpr double soon = 1e-3;  // s
    const double width = std::max(Cells::width_for(ball.radius), path.max_speed(sim_.end) * soon);
    sim_.cells.insert(i, sim_.cells.level_for(width), ball.position);
    update_swept_bounds(i, time, {path.flight.position, path.flight.velocity});
}

void Paths::update_swept_bounds(BallIndex i, double time, const Flight::Motion& here) {
    Particle& particle = sim_.particles[i];
    const Path& path = particle.motion.path;
    const auto [at, velocity] = here;
    if (sim_.balls[i].asleep) {
        particle.cell_exit = never_touch;
        particle.bounds = bounds_of(at, sim_.balls[i].radius);
        return;
    }
    const double left = sim_.end - time;
    Vec2 top{std::abs(path.flight.acceleration.x), std::abs(path.flight.acceleration.y)};
    if (path.is_taylor() || path.flight.drag > 0) {
        const double most = path.max_acceleration(sim_.end);
        top = {most, most};
    }
    const double duration = std::min(sim_.cells.time_in_cell(i, at, velocity, top), left);
    particle.cell_exit = duration < left ? time + duration : never_touch;
    // How far the acceleration alone can take the ball, and with its velocity.
    const Vec2 drift = 0.5 * duration * duration * top;
    const Vec2 far = Vec2{std::abs(velocity.x), std::abs(velocity.y)} * duration + drift;
    particle.bounds = {at - Vec2{velocity.x > 0 ? drift.x : far.x, velocity.y > 0 ? drift.y : far.y},
                       at + Vec2{velocity.x > 0 ? far.x : drift.x, velocity.y > 0 ? far.y : drift.y}};
    particle.bounds = grown(particle.bounds, (1 + sleep_distance) * sim_.balls[i].radius);
}

/// Finds the features that the ball touches without moving along their normals.
void Paths::find_supports(BallIndex i, double time) {
    supports_.clear();
    const Ball& ball = sim_.balls[i];
    const Particle& particle = sim_.particles[i];
    const double slack = support_gap * ball.radius + gap_rounding(ball.position, ball.radius);
    for (const FeatureIndex f : sim_.features_near(bounds_of(ball.position, ball.radius + 2 * slack))) {
        const Feature& feature = sim_.features[f];
        if (&feature == particle.separated_from || gates_.ignores(feature, ball)) continue;
        const Turning& turning = sim_.turnings[feature.part];
        const Pose pose = turning.pose(time);
        ++sim_.record->statistics.narrow_tests;
        const Closest closest = closest_point(feature, ball.position, ball.radius, pose);
        const double gap = closest.distance - ball.radius;
        if (!closest.facing || gap > slack) continue;
        // To begin on the surface of a part that has moved into the ball would be a jump.
        if (gap < -deep_overlap * ball.radius && Table::moves(sim_.scene.parts[feature.part])) continue;
        const Vec2 normal = closest.normal;
        if (feature.gate && gates_.lets_through(feature.part, ball, time)) continue;
        RestingContact contact = resting_contact_at(feature, turning, ball, normal, time, sim_.external);
        const Mixed mixed = sim_.layout.mixed(ball, sim_.scene.parts[feature.part]);
        contact.friction = mixed.friction;
        const Vec2 relative = ball.velocity - contact.surface_velocity;
        const double force = std::max(0.0, contact.force);
        const double still = (1e-12 + direction_rounding(feature)) * length(relative) +
                             shortest_bounce * std::sqrt(ball.radius * force) +
                             unending_bounce(feature, turning.rate_at(time) != 0, force,
                                             gap_rounding(ball.position, ball.radius), mixed.restitution);
        if (std::abs(dot(relative, normal)) > still) continue;
        if (feature.gate) sim_.table.set_blocked(feature.part, ball.number, true);
        const double scale = length(sim_.external.gravity) + length_squared(relative) / ball.radius;
        contact.loaded = contact.force > 1e-12 * scale;
        supports_.push_back(contact);
    }
}

/// Notes the straight faces that the ball touches, that carry no force, and that do not move until the end of
/// the window.
void Paths::note_tangent_faces(Particle& particle) const {
    const double time = particle.motion.path.start;
    for (const RestingContact& contact : supports_) {
        const auto* line = std::get_if<Line>(&contact.feature->is);
        if (line == nullptr || contact.loaded || contact.turning->rate_at(time) != 0) continue;
        particle.tangent_faces.add(contact.turning->pose(time).apply(line->start), contact.normal);
    }
}

/// Chooses the support on which the ball rests, or two between which it lies still.
void Paths::choose_support(BallIndex i, double time) {
    const Ball& ball = sim_.balls[i];
    Particle& particle = sim_.particles[i];
    for (const RestingContact& support : supports_) {
        if (!support.loaded || !supports_alone(support, supports_, ball, time)) continue;
        particle.resting_on = support.feature;
        if (!constrain(support, ball, time, sim_.end, sim_.external, particle.motion))
            sim_.join_island(i, time);
        return;
    }
    const double slow = 1e-6 * std::sqrt(ball.radius * length(sim_.external.gravity));
    const bool moving = std::ranges::any_of(
        supports_, [&](const RestingContact& support) { return support.turning->rate_at(time) != 0; });
    if (!moving && length(ball.velocity) <= slow) rest_between(i, time);
    // Pressed between supports, one of which moves: no path of its own leads on from here.
    if (particle.resting_on == nullptr && std::ranges::any_of(supports_, &RestingContact::loaded))
        sim_.join_island(i, time);
}

/// Holds a ball still between two static supports, if their forces balance gravity. While it spins, Coulomb
/// friction of both slows it; a third support is ignored.
void Paths::rest_between(BallIndex i, double time) {
    Ball& ball = sim_.balls[i];
    if (std::abs(ball.spin) <= 1e-12 * std::sqrt(length(sim_.external.gravity) / ball.radius)) ball.spin = 0;
    const double turning = ball.spin > 0 ? 1 : ball.spin < 0 ? -1 : 0;
    const auto direction = [&](const RestingContact& contact) {
        return contact.normal + turning * contact.friction * perp(contact.normal);
    };
    for (const RestingContact& first : supports_)
        for (const RestingContact& second : supports_) {
            if (&first == &second || !first.loaded) continue;
            const Vec2 u = direction(first), v = direction(second);
            const double across = cross(u, v), none = 1e-12 * length(sim_.external.gravity);
            if (std::abs(across) < 1e-12) continue;
            const double force_u = -cross(sim_.external.gravity, v) / across,
                         force_v = -cross(u, sim_.external.gravity) / across;
            if (force_u < -none || force_v < -none) continue;
            const double rubbed = 2 * (first.friction * force_u + second.friction * force_v) / ball.radius;
            ConstrainedPath& motion = sim_.particles[i].motion;
            sim_.particles[i].resting_on = first.feature;
            motion.path.flight = {ball.position, {}, {}, 0};
            motion.spin_rate = -turning * rubbed;
            if (ball.spin != 0 && rubbed > 0) motion.until = time + std::abs(ball.spin) / rubbed;
            return;
        }
}

}  // namespace flipside::custom
