#include <algorithm>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

namespace {

/// Hops shorter than this, in units of √(r/a), do not happen: the contact holds.
constexpr double shortest_hop = 1e-9;
/// Faces meet smoothly whose normals have at least this cosine (1.4e-3 rad; see joint_angle).
constexpr double smooth_joint = 1 - 1e-6;
/// A touch of a bend is found by steps and late by up to `rounding` of the gap. A hop that gains as much
/// speed by it as its bounce loses comes back for ever: the speed below which that happens, m/s.
double unending_hop(const Feature& feature, double force, double rounding, double restitution) {
    if (std::holds_alternative<Line>(feature.is) || restitution >= 1) return 0;
    return restitution * std::sqrt(2 * force * rounding / (1 - restitution * restitution));
}

/// How far rounding of its ends may turn a straight face, rad.
double direction_rounding(const Feature& feature) {
    const auto* line = std::get_if<Line>(&feature.is);
    if (line == nullptr) return 0;
    return 16 * 0x1p-53 * (std::abs(line->start.x) + std::abs(line->start.y)) / line->length;
}

}  // namespace

/// Finds the path of a ball from where it is: along what it rests on, or free.
void ContinuousSolver::set_out(BallIndex i, double time) {
    Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    mover.hops = mover.waits = flying_[i].creeps = false;
    if (ball.asleep && beside_moving_part(i)) ball.asleep = false;
    mover.resting_on = nullptr;
    mover.glides.clear();
    mover.way.fly(ball.asleep ? Flight{ball.position, ball.velocity, {}, 0}
                              : Flight{ball.position, ball.velocity, drive_.gravity, drive_.drag},
                  time);
    Flying& flying = flying_[i];
    ++flying.changes;
    flying.position = ball.position;
    flying.velocity = ball.velocity;
    flying.start = time;
    flying.freely = !ball.asleep;
    list_in_cell(i, time);
    if (ball.asleep) return;
    find_supports(i, time);
    if (supports_.empty()) return;
    choose_support(i, time);
    flying.freely = mover.resting_on == nullptr;
    if (flying.freely) return note_glides(mover);
    list_in_cell(i, time);
}

/// Lists a ball that sets out in the cell where it is: a wide one if it is fast, so that it does not leave
/// one more often than a thousand times a second.
void ContinuousSolver::list_in_cell(BallIndex i, double time) {
    const Ball& ball = bodies_[i];
    constexpr double soon = 1e-3;  // s
    cells_.choose_level(i,
                        std::max(Cells::width_for(ball.radius), movers_[i].way.path.max_speed(dt_) * soon));
    cells_.put(i, ball.position);
    cover_way(i, time);
}

/// Finds how long the ball stays listed in its cell, and what it can meet until then.
void ContinuousSolver::cover_way(BallIndex i, double time) {
    Mover& mover = movers_[i];
    const Path& path = mover.way.path;
    Vec2 at = path.flight.position;
    if (bodies_[i].asleep) {
        mover.horizon = never_touch;
        mover.bounds = bounds_of(at, bodies_[i].radius);
        return;
    }
    const auto [here, velocity] = path.at(time);
    const double left = dt_ - time;
    Vec2 top{std::abs(path.flight.acceleration.x), std::abs(path.flight.acceleration.y)};
    if (path.swings() || path.flight.drag > 0) {
        const double most = path.max_acceleration(dt_);
        top = {most, most};
    }
    const double stays = std::min(cells_.stays(i, here, velocity, top), left);
    mover.horizon = stays < left ? time + stays : never_touch;
    const Vec2 far = Vec2{std::abs(velocity.x), std::abs(velocity.y)} * stays + 0.5 * stays * stays * top;
    mover.bounds = {here - Vec2{velocity.x > 0 ? 0.5 * stays * stays * top.x : far.x,
                                velocity.y > 0 ? 0.5 * stays * stays * top.y : far.y},
                    here + Vec2{velocity.x > 0 ? far.x : 0.5 * stays * stays * top.x,
                                velocity.y > 0 ? far.y : 0.5 * stays * stays * top.y}};
    mover.bounds = grown(mover.bounds, bodies_[i].radius);
    record_->statistics.pair_tests += mover.near.cover(mover.bounds, ranges_);
}

bool ContinuousSolver::beside_moving_part(BallIndex i) {
    const Ball& ball = bodies_[i];
    const Box here = bounds_of(ball.position, ball.radius * (1 + touch_distance));
    record_->statistics.pair_tests += movers_[i].near.cover(here, ranges_);
    return std::ranges::any_of(movers_[i].near.list(), [&](FeatureIndex f) {
        return !turnings_[features_[f].part].still() && overlap(here, ranges_[f]);
    });
}

/// What the ball touches without moving along the normal.
void ContinuousSolver::find_supports(BallIndex i, double time) {
    supports_.clear();
    const Ball& ball = bodies_[i];
    const Mover& mover = movers_[i];
    const Box here = bounds_of(ball.position, ball.radius * (1 + 1e-6));
    for (const FeatureIndex f : mover.near.list()) {
        if (!overlap(here, ranges_[f])) continue;
        const Feature& feature = features_[f];
        if (&feature == mover.released || ignores(feature, ball)) continue;
        const Turning& turning = turnings_[feature.part];
        const Pose pose = turning.pose(time);
        ++record_->statistics.narrow_tests;
        const Closest closest = closest_point(feature, pose.undo(ball.position), ball.radius);
        const double gap = closest.distance - ball.radius;
        if (!closest.facing || gap > support_gap * ball.radius + gap_rounding(ball.position, ball.radius))
            continue;
        const Vec2 normal = pose.angle == 0 ? closest.normal : rotated(closest.normal, pose.angle);
        if (feature.gate && lets_through(feature.part, ball, time)) continue;
        RestingContact contact = resting_contact_at(feature, turning, ball, normal, time, drive_);
        const Mixed mixed = layout_.mixed(ball.material, scene_.parts[feature.part].material);
        contact.friction = mixed.friction;
        const Vec2 relative = ball.velocity - contact.surface_velocity;
        const double force = std::max(0.0, contact.force);
        const double still =
            (1e-12 + direction_rounding(feature)) * length(relative) +
            shortest_hop * std::sqrt(ball.radius * force) +
            unending_hop(feature, force, gap_rounding(ball.position, ball.radius), mixed.restitution);
        if (std::abs(dot(relative, normal)) > still) continue;
        if (feature.gate) table_->set_blocked(feature.part, ball.number, true);
        const double scale = length(drive_.gravity) + length_squared(relative) / ball.radius;
        supports_.push_back({contact, contact.force > 1e-12 * scale});
    }
}

/// The faces among the supports of a ball that none of them holds.
void ContinuousSolver::note_glides(Mover& mover) const {
    for (const auto& [contact, pressed, way, ahead] : supports_) {
        const auto* line = std::get_if<Line>(&contact.feature->is);
        if (line == nullptr || pressed || !contact.turning->still()) continue;
        mover.glides.add(contact.turning->begin.apply(line->start), contact.normal);
    }
}

/// Which way each support leads the ball: on in its motion, or where it is driven if it does not move.
void ContinuousSolver::find_ways(const Ball& ball, double time) {
    for (Support& support : supports_) {
        const RestingContact& contact = support.contact;
        const Vec2 tangent = perp(contact.normal);
        const double along = dot(ball.velocity - contact.surface_velocity, tangent);
        support.way = (along != 0 ? along : contact.driven) > 0 ? tangent : -tangent;
        const Pose pose = contact.turning->pose(time);
        support.ahead =
            ahead(*contact.feature, pose.undo(ball.position), rotated(support.way, -pose.angle), ball.radius);
    }
}

/// Of two faces that meet smoothly, whether this one holds. Forces cannot tell, for curves need more: it is
/// the one that does not lead into the other; or where both or none do, the one that goes on for longer.
bool ContinuousSolver::goes_before(const Support& support, const Support& other) {
    const bool clear = dot(support.way, other.contact.normal) >= -speed_rounding / 2;
    const bool other_clear = dot(other.way, support.contact.normal) >= -speed_rounding / 2;
    if (clear != other_clear) return clear;
    return support.ahead > other.ahead || (support.ahead == other.ahead && &support < &other);
}

/// Whether a support holds the ball alone: with its friction its force keeps the ball off all others.
bool ContinuousSolver::holds_alone(const Support& support, const Ball& ball) const {
    const RestingContact& contact = support.contact;
    const Vec2 held = contact.force * contact.normal + friction_of(contact, ball) * perp(contact.normal);
    return std::ranges::all_of(supports_, [&](const Support& other) {
        if (&other == &support) return true;
        if (dot(other.contact.normal, contact.normal) >= smooth_joint) return goes_before(support, other);
        return other.contact.force - dot(held, other.contact.normal) <= 1e-9 * contact.force;
    });
}

/// Chooses what the ball rests on among its supports: one, or two between which it stays.
void ContinuousSolver::choose_support(BallIndex i, double time) {
    const Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    if (supports_.size() > 1) find_ways(ball, time);
    for (const Support& support : supports_) {
        if (!support.pressed || !holds_alone(support, ball)) continue;
        mover.resting_on = support.contact.feature;
        if (!constrain(support.contact, ball, time, dt_, drive_, mover.way)) join(i, time);
        return;
    }
    const double slow = 1e-6 * std::sqrt(ball.radius * length(drive_.gravity));
    const bool moving = std::ranges::any_of(
        supports_, [&](const Support& support) { return support.contact.turning->rate_at(time) != 0; });
    if (!moving && length(ball.velocity) <= slow) stay_between(i, time);
}

/// A ball that two still supports keep where it is: the forces of both bear it. While it spins, both rub it
/// by Coulomb's law until it has come to rest; a third of them is left out.
void ContinuousSolver::stay_between(BallIndex i, double time) {
    Ball& ball = bodies_[i];
    if (std::abs(ball.spin) <= 1e-12 * std::sqrt(length(drive_.gravity) / ball.radius)) ball.spin = 0;
    const double turning = ball.spin > 0 ? 1 : ball.spin < 0 ? -1 : 0;
    const auto direction = [&](const RestingContact& contact) {
        return contact.normal + turning * contact.friction * perp(contact.normal);
    };
    for (const Support& first : supports_)
        for (const Support& second : supports_) {
            if (&first == &second || !first.pressed) continue;
            const Vec2 u = direction(first.contact), v = direction(second.contact);
            const double across = cross(u, v), none = 1e-12 * length(drive_.gravity);
            if (std::abs(across) < 1e-12) continue;
            const double force_u = -cross(drive_.gravity, v) / across,
                         force_v = -cross(u, drive_.gravity) / across;
            if (force_u < -none || force_v < -none) continue;
            const double rubbed =
                2 * (first.contact.friction * force_u + second.contact.friction * force_v) / ball.radius;
            ConstrainedPath& way = movers_[i].way;
            movers_[i].resting_on = first.contact.feature;
            way.path.flight = {ball.position, {}, {}, 0};
            way.spin_rate = -turning * rubbed;
            if (ball.spin != 0 && rubbed > 0) way.until = time + std::abs(ball.spin) / rubbed;
            return;
        }
}

}  // namespace flipside::custom
