#include <algorithm>
#include <cmath>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

namespace {

/// A ball that moves no farther than this in a long tick creeps, in radii.
constexpr double creep_distance = 0.02;
/// So many touches of balls, each within a tick of the last, and a ball rattles.
constexpr int most_hits = 10;

}  // namespace

/// Whether a ball of this speed, m/s, hardly moves in a long tick.
bool ContinuousSolver::creeps_at(double speed, const Ball& ball) {
    return speed * long_tick_length <= creep_distance * ball.radius;
}

/// Takes a ball into an island. Until the next tick it goes on as it does, but meets no other of an island.
void ContinuousSolver::join(BallIndex i, double time) {
    Mover& mover = movers_[i];
    if (bodies_[i].asleep || mover.lost || flying_[i].pressed) return;
    if (!any_pressed_) next_tick_ = next_tick(time);
    flying_[i].pressed = any_pressed_ = true;
    std::uint64_t& counted = record_->statistics.handed_over;
    counted = std::max<std::uint64_t>(counted, 1);
    mover.hops = false;
    mover.loaded_at = time;
}

void ContinuousSolver::leave(BallIndex i) {
    flying_[i].pressed = false;
}

/// Events of a ball at one instant without end, or impacts that come to nothing: it is squeezed. Then all
/// that touches it, and what touches that, is solved at once, however fast it comes, as an impact without
/// bounce.
void ContinuousSolver::crush(BallIndex first, double time) {
    members_.clear();
    const auto squeeze = [&](BallIndex i) {
        if (bodies_[i].asleep || movers_[i].lost || movers_[i].crushed) return;
        join(i, time);
        movers_[i].crushed = true;
        members_.push_back(i);
    };
    squeeze(first);
    for (std::size_t seen = 0; seen < members_.size();) {
        const BallIndex i = members_[seen++];
        const Vec2 here = movers_[i].way.path.position(time);
        cells_.each_near(i, [&](BallIndex j) {
            const double reach = bodies_[i].radius + bodies_[j].radius;
            const double apart = length(movers_[j].way.path.position(time) - here);
            if (apart <= (1 + press_distance) * reach && layers_meet(bodies_[i], bodies_[j])) squeeze(j);
        });
    }
    tick(time);
}

/// Where that did not help, the ball stays where it is until the next tick.
void ContinuousSolver::wait(BallIndex i, double time) {
    move_to(i, time);
    join(i, time);
    Mover& mover = movers_[i];
    mover.waits = true;
    flying_[i].creeps = false;
    mover.set_out_with = mover.arrives_with = bodies_[i].velocity;
    set_out_member(i, {bodies_[i].position, {}, {}, 0}, time, next_tick(time));
    predict(i, time);
    // It looks for nobody, so those beside it are to look for it.
    cells_.each_near(i, [&](BallIndex j) {
        if (!movers_[j].waits) predict(j, time);
    });
}

/// Of a ball that was moved along its path to this time. That of a member changes evenly between ticks,
/// while it hops.
Vec2 ContinuousSolver::true_velocity(BallIndex i, double time) const {
    const Mover& mover = movers_[i];
    if (!mover.hops) return bodies_[i].velocity;
    const double start = mover.way.path.start, part = (time - start) / (mover.way.until - start);
    return mover.set_out_with + part * (mover.arrives_with - mover.set_out_with);
}

/// A member as it is at a time.
void ContinuousSolver::follow(Ball& ball, const Mover& mover, double time) const {
    const double start = mover.way.path.start;
    advance(ball, mover.way, time);
    if (!mover.hops) return;
    const double part = (time - start) / (mover.way.until - start);
    ball.velocity = mover.set_out_with + part * (mover.arrives_with - mover.set_out_with);
}

void ContinuousSolver::move_to(BallIndex i, double time) {
    if (flying_[i].pressed)
        follow(bodies_[i], movers_[i], time);
    else
        advance(bodies_[i], movers_[i].way, time);
}

/// A member goes along this path until its next tick.
void ContinuousSolver::set_out_member(BallIndex i, const Flight& flight, double time, double until) {
    Mover& mover = movers_[i];
    any_pressed_ = mover.hops = true;
    mover.resting_on = mover.released = nullptr;
    mover.glides.clear();
    mover.way.fly(flight, time);
    mover.way.until = until;
    bodies_[i].position = flight.position;
    bodies_[i].velocity = flight.velocity;
    Flying& flying = flying_[i];
    ++flying.changes;
    flying.position = flight.position;
    flying.velocity = flight.velocity;
    flying.start = time;
    flying.freely = flight.acceleration == drive_.gravity && flight.drag == drive_.drag;
    list_in_cell(i, time);
}

/// The path of a member: a hop to where the forces bring it. So all balls fly under one gravity, and any two
/// meet as if they flew straight. One that nothing presses flies freely, and leaves after some ticks.
void ContinuousSolver::hop(BallIndex i, double time, const ContactSolver::Body& body) {
    Mover& mover = movers_[i];
    const Ball& ball = bodies_[i];
    if (time - mover.loaded_at > longest_unloaded) {
        leave(i);
        bodies_[i].position = body.position;
        return set_out(i, time);
    }
    const double duration = next_tick_ - time;
    // What is stopped by more than its weight is stopped at once: a blow within the tick must not find it
    // with the speed that it has lost.
    const bool stopped = length(body.velocity - ball.velocity) > 2 * length(scene_.gravity) * tick_length;
    mover.set_out_with = stopped ? body.velocity : ball.velocity;
    mover.arrives_with = body.velocity;
    const TimeInterval interval(drive_.drag, duration);
    const Vec2 thrown = mover.sides == 0
                            ? ball.velocity
                            : (duration * body.velocity - interval.fallen * drive_.gravity) / interval.shrunk;
    set_out_member(i, {body.position, thrown, drive_.gravity, drive_.drag}, time, next_tick_);
    mover.way.spin_rate = (body.spin - ball.spin) / duration;
}

/// The path of a member that hardly moves: evenly on through a long tick.
void ContinuousSolver::creep(BallIndex i, double time, double until, const ContactSolver::Body& body) {
    Mover& mover = movers_[i];
    mover.set_out_with = mover.arrives_with = body.velocity;
    set_out_member(i, {body.position, body.velocity, {}, 0}, time, until);
    mover.way.spin_rate = (body.spin - bodies_[i].spin) / (until - time);
    flying_[i].creeps = true;
}

/// Whether two balls come together slowly that have both met balls again and again: in a crowd that comes to
/// rest impacts follow each other ever faster (McNamara and Young 1994, "Inelastic collapse in two
/// dimensions"). They stay together.
bool ContinuousSolver::rattles(BallIndex i, BallIndex j, double approach, double time) {
    for (Mover* mover : {&movers_[i], &movers_[j]}) {
        mover->hits = time - mover->last_hit < tick_length ? mover->hits + 1 : 0;
        mover->last_hit = time;
    }
    return approach <= slow_ && std::min(movers_[i].hits, movers_[j].hits) >= most_hits;
}

/// Whether two members touch and do not come together faster than at rest.
bool ContinuousSolver::in_slow_touch(BallIndex i, BallIndex j, double time) const {
    const auto a = movers_[i].way.path.at(time), b = movers_[j].way.path.at(time);
    const Vec2 between = a.position - b.position, normal = unit(between);
    return -dot(a.velocity - b.velocity, normal) <= slow_;
}

/// The same for a member and a feature. One that joined since the last tick flies on, and a whole tick at
/// that speed would take it into the part: it is left to itself only where it would come to rest there
/// anyway.
bool ContinuousSolver::rests_on(BallIndex i, const Feature& feature, const Pose& pose, double time) const {
    const auto here = movers_[i].way.path.at(time);
    const Closest closest = closest_point(feature, pose.undo(here.position), bodies_[i].radius);
    const Vec2 normal = pose.angle == 0 ? closest.normal : rotated(closest.normal, pose.angle);
    const Vec2 point = here.position - closest.distance * normal;
    const Vec2 surface = cross(turnings_[feature.part].rate_at(time), point - pose.pivot);
    const double closing = -dot(here.velocity - surface, normal);
    if (flying_[i].creeps) return creeps_at(closing, bodies_[i]);
    return closing <= (movers_[i].hops ? slow_ : scene_.rest_speed);
}

}  // namespace flipside::custom
