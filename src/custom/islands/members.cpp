// Members of contact islands: which balls are, and the paths that they follow between ticks.

#include <algorithm>
#include <cmath>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

namespace {

/// Radii: a member that moves farther than this in a tick rests on no part. The chord of a slower one enters
/// a concave arc of at least its own radius by at most farthest_chord²/8 = 0.00125 radii.
constexpr double farthest_chord = 0.1;
/// Radii of the smaller one: two members that move farther past each other in a tick have exact impacts. The
/// direction of their contact turns by up to 0.2 rad in the tick, which the contact solver ignores.
constexpr double farthest_slide = 0.4;
/// Radii: a member that moves no farther than this in a long tick creeps.
constexpr double creep_distance = 0.02;
/// Contacts with balls in a row, each within a tick of the one before, that show an inelastic collapse.
constexpr int most_hits = 20;

}  // namespace

/// Whether a ball of this speed, m/s, moves less than creep_distance in a long tick.
bool ContinuousSolver::creeps_at(double speed, const Ball& ball) {
    return speed * long_tick_length <= creep_distance * ball.radius;
}

/// Finds the members of islands at the start of the window: balls with a contact force at the end of the
/// previous window, balls in resting contact, and their neighbours in slow contact. Balls that deeply overlap
/// each other are members too: in free flight they would never separate.
void ContinuousSolver::find_islands() {
    members_.clear();
    const auto join_once = [&](BallIndex i) {
        if (bodies_[i].asleep || hot_[i].in_island) return;
        join_island(i, 0);
        members_.push_back(i);
    };
    for (const ContactForce& force : table_.memory().forces) {
        const Ball *a = find_ball(bodies_, force.a), *b = find_ball(bodies_, force.b);
        if (a == nullptr || b == nullptr) continue;
        const auto i = static_cast<BallIndex>(a - bodies_.data()),
                   j = static_cast<BallIndex>(b - bodies_.data());
        ball_forces_.add({i, j, force.normal, force.tangent});
        join_once(i), join_once(j);
    }
    ball_forces_.merge();
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        if (bodies_[i].asleep) continue;
        cells_.query_neighbours(i, [&](BallIndex j) {
            ++record_->statistics.pair_tests;
            if ((j > i || bodies_[j].asleep) && in_resting_contact(i, j, false)) join_once(i), join_once(j);
        });
    }
    for (std::size_t seen = 0; seen < members_.size();) {
        const BallIndex i = members_[seen++];
        cells_.query_neighbours(i, [&](BallIndex j) {
            if (!hot_[j].in_island && in_resting_contact(i, j, true)) join_once(j);
        });
    }
}

/// Whether two balls are in resting contact, or overlap deeply. `beside_island`: one of them is in an island.
bool ContinuousSolver::in_resting_contact(BallIndex i, BallIndex j, bool beside_island) const {
    const Ball &a = bodies_[i], &b = bodies_[j];
    const Vec2 between = a.position - b.position;
    const double gap = touch_distance * std::min(a.radius, b.radius);
    const double reach = a.radius + b.radius + gap;
    if (length_squared(between) > reach * reach || !layers_meet(a, b)) return false;
    const double out = a.radius + b.radius - deep_overlap * std::min(a.radius, b.radius);
    if (length_squared(between) < out * out) return true;
    const double apart = dot(a.velocity - b.velocity, unit(between));
    if (beside_island) return std::abs(apart) <= scene_.rest_speed;
    const double closing = closing_acceleration(i, j, 0);
    if (closing <= 1e-9 * length(scene_.gravity) || apart < -scene_.rest_speed) return false;
    return apart <= 0 || apart * apart <= 2 * closing * gap;
}

/// Acceleration with which two touching balls would approach each other without a contact force, m/s².
double ContinuousSolver::closing_acceleration(BallIndex i, BallIndex j, double time) const {
    const Path &a = movers_[i].motion.path, &b = movers_[j].motion.path;
    const Vec2 between = a.position(time) - b.position(time), n = unit(between);
    const double across = cross(n, a.velocity(time) - b.velocity(time));
    return -dot(a.acceleration(time) - b.acceleration(time), n) - across * across / length(between);
}

/// Makes a ball a member of an island. It keeps its path until the next tick, but has no slow contacts with
/// other members.
void ContinuousSolver::join_island(BallIndex i, double time) {
    Mover& mover = movers_[i];
    if (bodies_[i].asleep || hot_[i].lost || hot_[i].in_island) return;
    if (!any_in_island_) next_tick_ = next_tick(time);
    hot_[i].in_island = any_in_island_ = true;
    std::uint64_t& counted = record_->statistics.handed_over;
    counted = std::max<std::uint64_t>(counted, 1);
    mover.on_tick_path = false;
    mover.last_loaded = time;
}

void ContinuousSolver::leave_island(BallIndex i) {
    hot_[i].in_island = false;
}

/// Handles a ball whose events at one instant, or whose insignificant impacts, have no end. All balls in
/// contact with it, directly or through others, are solved at once as one impact without restitution.
void ContinuousSolver::solve_jammed(BallIndex first, double time) {
    members_.clear();
    const auto mark_jammed = [&](BallIndex i) {
        if (bodies_[i].asleep || hot_[i].lost || movers_[i].jammed) return;
        join_island(i, time);
        movers_[i].jammed = true;
        members_.push_back(i);
    };
    mark_jammed(first);
    for (std::size_t seen = 0; seen < members_.size();) {
        const BallIndex i = members_[seen++];
        const Vec2 here = movers_[i].motion.path.position(time);
        cells_.query_neighbours(i, [&](BallIndex j) {
            const double reach = bodies_[i].radius + bodies_[j].radius;
            const double apart = length(movers_[j].motion.path.position(time) - here);
            if (apart <= (1 + resting_distance) * reach && layers_meet(bodies_[i], bodies_[j]))
                mark_jammed(j);
        });
    }
    tick(time);
}

/// Holds a ball in place until the next tick, where solve_jammed() did not help.
void ContinuousSolver::freeze(BallIndex i, double time) {
    advance_to(i, time);
    join_island(i, time);
    hot_[i].creeps = false;
    stay_frozen(i, bodies_[i].velocity, time);
    predict(i, time);
    // It predicts no events of its own, so its neighbours must predict theirs with it.
    cells_.query_neighbours(i, [&](BallIndex j) {
        if (!movers_[j].frozen) predict(j, time);
    });
}

/// Holds a ball in place until the next tick; then it moves on with this velocity. An impact changes the
/// velocity alone: a ball that could be pushed away again would have events without end.
void ContinuousSolver::stay_frozen(BallIndex i, Vec2 velocity, double time) {
    Mover& mover = movers_[i];
    mover.frozen = true;
    mover.velocity_begin = mover.velocity_end = velocity;
    start_member_path(i, {bodies_[i].position, {}, {}, 0}, time, next_tick(time));
}

/// Velocity of a ball that was advanced along its path to this time. The velocity of a member is interpolated
/// linearly between ticks; that of its parabola serves only to reach the solved position.
Vec2 ContinuousSolver::true_velocity(BallIndex i, double time) const {
    const Mover& mover = movers_[i];
    if (!mover.on_tick_path) return bodies_[i].velocity;
    const double start = mover.motion.path.start, duration = mover.motion.until - start;
    const double part = duration > 0 ? (time - start) / duration : 1;  // 0 at the end of the window
    return mover.velocity_begin + part * (mover.velocity_end - mover.velocity_begin);
}

/// Moves a ball along its path to `time`, with its true velocity.
void ContinuousSolver::advance_to(BallIndex i, double time) {
    advance(bodies_[i], movers_[i].motion, time);
    bodies_[i].velocity = true_velocity(i, time);
}

/// Starts the path of a member until its next tick.
void ContinuousSolver::start_member_path(BallIndex i, const Flight& flight, double time, double until) {
    Mover& mover = movers_[i];
    any_in_island_ = mover.on_tick_path = true;
    mover.resting_on = mover.separated_from = nullptr;
    mover.tangent_faces.clear();
    mover.motion.fly(flight, time);
    mover.motion.until = until;
    bodies_[i].position = flight.position;
    bodies_[i].velocity = flight.velocity;
    HotState& hot = hot_[i];
    ++hot.version;
    hot.position = flight.position;
    hot.velocity = flight.velocity;
    hot.start = time;
    hot.ballistic = flight.acceleration == external_.gravity && flight.drag == external_.drag;
    list_in_cell(i, time);
}

/// Starts the path of a member over a tick: the parabola under gravity and drag that ends at the solved
/// position. Since all balls then have the same acceleration, the relative motion of any two is straight. A
/// member without a load flies freely, and leaves the island after some ticks.
void ContinuousSolver::start_tick_path(BallIndex i, double time, const ContactSolver::Body& body) {
    Mover& mover = movers_[i];
    const Ball& ball = bodies_[i];
    if (time - mover.last_loaded > longest_unloaded) {
        leave_island(i);
        bodies_[i].position = body.position;
        return start_path(i, time);
    }
    const double duration = next_tick_ - time;
    // A velocity change greater than that of gravity applies at once, so that an impact within the tick does
    // not see the old velocity.
    const bool stopped = length(body.velocity - ball.velocity) > 2 * length(scene_.gravity) * tick_length;
    mover.velocity_begin = stopped ? body.velocity : ball.velocity;
    mover.velocity_end = body.velocity;
    const TimeInterval interval(external_.drag, duration);
    const Vec2 thrown =
        mover.loads == 0 ? ball.velocity
                         : (duration * body.velocity - interval.fallen * external_.gravity) / interval.shrunk;
    start_member_path(i, {body.position, thrown, external_.gravity, external_.drag}, time, next_tick_);
    mover.motion.spin_rate = (body.spin - ball.spin) / duration;
}

/// Starts the path of a creeping member: uniform motion over a long tick.
void ContinuousSolver::start_creep_path(BallIndex i, double time, double until,
                                        const ContactSolver::Body& body) {
    Mover& mover = movers_[i];
    mover.velocity_begin = mover.velocity_end = body.velocity;
    start_member_path(i, {body.position, body.velocity, {}, 0}, time, until);
    mover.motion.spin_rate = (body.spin - bodies_[i].spin) / (until - time);
    hot_[i].creeps = true;
}

/// Whether a slow contact belongs to an inelastic collapse: in a heap that comes to rest, impacts follow each
/// other ever faster without end (McNamara and Young 1994, "Inelastic collapse in two dimensions"). Then it
/// becomes a resting contact.
bool ContinuousSolver::collapses(BallIndex i, BallIndex j, double approach, double time) {
    for (Mover* mover : {&movers_[i], &movers_[j]}) {
        mover->hits = time - mover->last_hit < tick_length ? mover->hits + 1 : 0;
        mover->last_hit = time;
    }
    return approach <= slow_ && std::min(movers_[i].hits, movers_[j].hits) >= most_hits;
}

/// Whether two members approach and pass each other no faster than in a resting contact.
bool ContinuousSolver::in_slow_contact(BallIndex i, BallIndex j, double time) const {
    const auto a = movers_[i].motion.path.at(time), b = movers_[j].motion.path.at(time);
    const Vec2 between = a.position - b.position, relative = a.velocity - b.velocity;
    const double farthest = farthest_slide * std::min(bodies_[i].radius, bodies_[j].radius);
    return length(relative) * tick_length <= farthest && -dot(relative, unit(between)) <= slow_;
}

/// The same for a member and a feature. A ball that joined since the last tick is still on its old path,
/// which could take it into the part before the next tick: for it the limit is rest_speed.
bool ContinuousSolver::rests_on(BallIndex i, const Feature& feature, const Pose& pose, double time) const {
    const auto here = movers_[i].motion.path.at(time);
    const auto [distance, normal, facing] = closest_point(feature, pose, here.position, bodies_[i].radius);
    const Vec2 point = here.position - distance * normal;
    const Vec2 surface = cross(turnings_[feature.part].rate_at(time), point - pose.pivot);
    const double closing = -dot(here.velocity - surface, normal);
    if (hot_[i].creeps) return creeps_at(closing, bodies_[i]);
    if (length(here.velocity) * tick_length > farthest_chord * bodies_[i].radius) return false;
    return closing <= (movers_[i].on_tick_path ? slow_ : scene_.rest_speed);
}

}  // namespace flipside::custom
