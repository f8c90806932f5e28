#include <algorithm>
#include <cmath>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

namespace {

/// So many ticks without a load, and a ball leaves its island.
constexpr int most_unloaded = 3;
/// So many touches of balls, each within a tick of the last, and a ball rattles.
constexpr int most_hits = 10;

}  // namespace

/// Takes a ball into an island. Until the next tick it goes on as it does, but meets no other of an island.
void ContinuousSolver::join(BallIndex i, double time) {
    Mover& mover = movers_[i];
    if (bodies_[i].asleep || mover.lost || flying_[i].pressed) return;
    if (!any_pressed_) next_tick_ = next_tick(time);
    flying_[i].pressed = any_pressed_ = true;
    std::uint64_t& counted = record_->statistics.handed_over;
    counted = std::max<std::uint64_t>(counted, 1);
    mover.hops = false;
    mover.unloaded = 0;
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
    Ball& ball = bodies_[i];
    mover.hops = mover.waits = true;
    mover.resting_on = mover.released = nullptr;
    mover.glides.clear();
    mover.set_out_with = mover.arrives_with = ball.velocity;
    ConstrainedPath& way = mover.way;
    way.fly({ball.position, {}, {}, 0}, time);
    way.until = next_tick(time);
    ball.velocity = {};
    Flying& flying = flying_[i];
    ++flying.changes;
    flying.freely = false;
    flying.start = time;
    flying.position = ball.position;
    flying.velocity = {};
    cover_way(i, time);
    predict(i, time);
    // It looks for nobody, so those beside it are to look for it.
    cells_.each_near(i, [&](BallIndex j) {
        if (!movers_[j].waits) predict(j, time);
    });
}

/// Ticks end with the window.
double ContinuousSolver::next_tick(double time) const {
    double left = std::ceil((dt_ - time) / tick_length) - 1;
    while (left > 0 && dt_ - left * tick_length <= time + 1e-3 * tick_length) --left;
    return left > 0 ? dt_ - left * tick_length : dt_;
}

/// Finds the forces in all islands until the next tick, and the way of their balls. Who was not pressed
/// by a ball lately leaves.
void ContinuousSolver::tick(double time) {
    members_.clear();
    const bool regular = time == next_tick_;
    next_tick_ = next_tick(time);
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        if (!flying_[i].pressed || movers_[i].lost) continue;
        movers_[i].waits = false;
        if (regular) movers_[i].crushed = false;
        move_to(i, time);
        members_.push_back(i);
    }
    any_pressed_ = false;
    record_->statistics.handed_over =
        std::max<std::uint64_t>(record_->statistics.handed_over, members_.size());
    const double duration = next_tick_ - time;
    if (members_.empty() || !(duration > 0)) return;
    gather(time, duration);
    while (!overlapped_.empty()) {
        take_in_overlapped(time);
        gather(time, duration);
    }
    contact_solver_.solve(duration, scene_.gravity);
    if (record_->trace) trace_tick(time, duration);
    note_loads(duration);
    for (BallIndex k = 0; k < members_.size(); ++k)
        set_out_pressed(members_[k], time, contact_solver_.bodies()[k]);
    if (time > 0) predict_together(members_, time);
}

/// Moving members apart may press one into a ball that flies: no event undoes that, so it becomes a member.
void ContinuousSolver::take_in_overlapped(double time) {
    for (const BallIndex j : overlapped_) {
        if (flying_[j].pressed) continue;
        move_to(j, time);
        join(j, time);
        members_.push_back(j);
    }
    std::ranges::sort(members_);
}

/// The bodies of all members, and the contacts that may press within the tick.
void ContinuousSolver::gather(double time, double duration) {
    contact_solver_.start();
    const TimeInterval interval(drive_.drag, duration);
    for (const BallIndex i : members_) {
        const Ball& ball = bodies_[i];
        const Vec2 driven =
            Flight{{}, ball.velocity, drive_.gravity}.velocity_after(interval) - ball.velocity;
        rank_[i] = contact_solver_.add(
            {ball.position, ball.velocity, driven, ball.spin, ball.radius, 1 / ball.mass, 1 / inertia(ball)});
    }
    deepest_ = 0;
    overlapped_.clear();
    RememberedForces of_balls(table_->memory().forces), of_parts(part_forces_);
    for (const BallIndex i : members_) {
        of_balls.go_on_to(movers_[i].number);
        cells_.each_near(i, [&](BallIndex j) { press_balls(i, j, time, duration, of_balls); });
    }
    for (const BallIndex i : members_) {
        of_parts.go_on_to(movers_[i].number);
        press_parts(i, time, duration, of_parts);
    }
}

/// Adds two balls that are in touch or will be, slowly; a fast approach is an event.
void ContinuousSolver::press_balls(BallIndex i, BallIndex j, double time, double duration,
                                   const RememberedForces& known) {
    const Ball &a = bodies_[i], &b = bodies_[j];
    ++record_->statistics.pair_tests;
    if (movers_[j].lost || (flying_[j].pressed && j > i)) return;
    const bool flies = !b.asleep && !flying_[j].pressed;
    const Vec2 between = a.position - (flies ? movers_[j].way.path.position(time) : b.position);
    const double reach = a.radius + b.radius,
                 slack = slow_ * duration + press_distance * std::min(a.radius, b.radius);
    const double square = length_squared(between);
    if (square >= (reach + slack) * (reach + slack) || square == 0 || !layers_meet(a, b)) return;
    const double distance = std::sqrt(square), gap = distance - reach;
    const Vec2 normal = between / distance;
    const bool deep = gap < -press_distance * std::min(a.radius, b.radius);
    if (flies) {
        if (deep) overlapped_.push_back(j);
        return;
    }
    deepest_ = std::max(deepest_, -gap);
    const Vec2 other_velocity = b.asleep ? Vec2{} : b.velocity;
    const bool crushed = movers_[i].crushed || movers_[j].crushed;
    if (!deep && !crushed && -dot(a.velocity - other_velocity, normal) > slow_) return;
    ++record_->statistics.narrow_tests;
    ++record_->statistics.contacts;
    const bool i_above = dot(normal, scene_.gravity) <= 0;
    ContactSolver::Contact contact;
    const auto other = b.asleep ? contact_solver_.add({b.position, {}, {}, 0, b.radius, 0, 0}) : rank_[j];
    contact.upper = i_above ? rank_[i] : other;
    contact.lower = i_above ? other : rank_[i];
    contact.normal = i_above ? normal : -normal;
    contact.gap_found = gap;
    contact.friction = layout_.mixed(a.material, b.material).friction;
    contact.height = -dot(a.position + b.position, scene_.gravity);
    contact.a = std::min(a.number, b.number), contact.b = std::max(a.number, b.number);
    press(contact, known, duration);
}

/// Adds a contact, which begins from the force that it had in the tick before.
void ContinuousSolver::press(ContactSolver::Contact& contact, const RememberedForces& known,
                             double duration) {
    if (const ContactForce* force = known.find(contact.a, contact.b)) {
        contact.impulse.normal = force->normal * duration;
        contact.impulse.tangent = force->tangent * duration;
    }
    contact_solver_.add(contact);
}

void ContinuousSolver::press_parts(BallIndex i, double time, double duration, const RememberedForces& known) {
    const Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    // Where balls are to be moved apart, they are kept from being moved through a part.
    const double slack = slow_ * duration + press_distance * ball.radius + 2 * deepest_;
    const Box box = bounds_of(ball.position, ball.radius + slack);
    record_->statistics.pair_tests += mover.near.cover(box, ranges_);
    PrimitiveIndex seen = layout_.size();
    for (const FeatureIndex f : mover.near.list()) {
        if (!overlap(box, ranges_[f]) || ignores(features_[f], ball) || features_[f].primitive == seen)
            continue;
        seen = features_[f].primitive;
        const Primitive& primitive = layout_.primitive(seen);
        const Turning& turning = turnings_[primitive.part];
        const Pose pose = turning.pose(time);
        if (!layout_.stops(*table_, seen, pose, ball)) continue;
        ++record_->statistics.narrow_tests;
        const Touch found = touch(ball.position, ball.radius, primitive, pose);
        if (found.past_end || found.separation > slack) continue;
        const Vec2 surface = cross(turning.rate_at(time), found.point - pose.pivot);
        const double closing = -dot(ball.velocity - surface, found.normal);
        ++record_->statistics.contacts;
        ContactSolver::Contact contact;
        contact.bounces =
            !mover.crushed && found.separation > -press_distance * ball.radius && closing > slow_;
        contact.upper = rank_[i];
        contact.lower = contact_solver_.add({found.point, surface, {}, 0, 0, 0, 0});
        contact.normal = found.normal;
        contact.gap_found = found.separation;
        contact.friction = layout_.mixed(ball.material, scene_.parts[primitive.part].material).friction;
        contact.height = -2 * dot(found.point, scene_.gravity);
        contact.with =
            turning.rate_at(time) == 0 ? ContactSolver::With::still_part : ContactSolver::With::moving_part;
        contact.a = seen, contact.b = ball.number;
        press(contact, known, duration);
    }
}

/// Remembers the forces between balls, and who is pressed: by a ball, or from two sides.
void ContinuousSolver::note_loads(double duration) {
    std::vector<ContactForce>& ball_forces = table_->memory().forces;
    const auto members = static_cast<BallIndex>(members_.size());
    ball_forces.clear();
    part_forces_.clear();
    for (const BallIndex i : members_) ++movers_[i].unloaded, movers_[i].sides = 0;
    for (const ContactSolver::Contact& contact : contact_solver_.contacts()) {
        if (contact.impulse.normal <= 0) continue;
        const auto bear = [&](BallIndex body, int sides) {
            if (body >= members) return;
            Mover& mover = movers_[members_[body]];
            if ((mover.sides += sides) >= 2) mover.unloaded = 0;
        };
        bear(contact.upper, contact.with == ContactSolver::With::ball ? 2 : 1);
        bear(contact.lower, contact.with == ContactSolver::With::ball ? 2 : 0);
        (contact.with == ContactSolver::With::ball ? ball_forces : part_forces_)
            .push_back({contact.a, contact.b, contact.impulse.normal / duration,
                        contact.impulse.tangent / duration});
    }
    std::ranges::sort(ball_forces, {}, rank);
    std::ranges::sort(part_forces_, {}, rank);
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

/// The path of a member: a hop to where the forces bring it. So all balls fly under one gravity, and any two
/// meet as if they flew straight. One that nothing presses flies freely, and leaves after some ticks.
void ContinuousSolver::set_out_pressed(BallIndex i, double time, const ContactSolver::Body& body) {
    Mover& mover = movers_[i];
    Ball& ball = bodies_[i];
    if (mover.unloaded >= most_unloaded) {
        leave(i);
        ball.position = body.position;
        return set_out(i, time);
    }
    any_pressed_ = true;
    const double duration = next_tick_ - time;
    mover.hops = true;
    mover.resting_on = mover.released = nullptr;
    mover.glides.clear();
    ball.position = body.position;
    // What is stopped by more than its weight is stopped at once: a blow within the tick must not find it
    // with the speed that it has lost.
    const bool stopped = length(body.velocity - ball.velocity) > 2 * length(scene_.gravity) * tick_length;
    mover.set_out_with = stopped ? body.velocity : ball.velocity;
    mover.arrives_with = body.velocity;
    const TimeInterval interval(drive_.drag, duration);
    const Vec2 thrown = mover.sides == 0
                            ? ball.velocity
                            : (duration * body.velocity - interval.fallen * drive_.gravity) / interval.shrunk;
    ConstrainedPath& way = mover.way;
    way.fly({ball.position, thrown, drive_.gravity, drive_.drag}, time);
    way.until = next_tick_;
    way.spin_rate = (body.spin - ball.spin) / duration;
    ball.velocity = thrown;
    Flying& flying = flying_[i];
    ++flying.changes;
    flying.position = ball.position;
    flying.velocity = thrown;
    flying.start = time;
    flying.freely = true;
    list_in_cell(i, time);
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
    return -dot(here.velocity - surface, normal) <= (movers_[i].hops ? slow_ : scene_.rest_speed);
}

}  // namespace flipside::custom
