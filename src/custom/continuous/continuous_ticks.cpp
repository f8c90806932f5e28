#include <algorithm>
#include <cmath>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

namespace {

/// Members are sorted out by speed where at least one in so many may creep; else it does not pay.
constexpr std::size_t creeping_share = 4;

}  // namespace

/// The next point of a grid of time that ends with the window.
double ContinuousSolver::next_on_grid(double time, double length) const {
    double left = std::ceil((dt_ - time) / length) - 1;
    while (left > 0 && dt_ - left * length <= time + 1e-3 * tick_length) --left;
    return left > 0 ? dt_ - left * length : dt_;
}

double ContinuousSolver::next_tick(double time) const {
    return next_on_grid(time, tick_length);
}

/// Finds the forces on members until the next tick, and their ways. What was not pressed by a ball lately
/// leaves. Those that creep are solved at every fourth tick alone; in between they stand for themselves as
/// parts do.
void ContinuousSolver::tick(double time) {
    members_.clear(), creeping_.clear();
    const bool regular = time == next_tick_;
    next_tick_ = next_tick(time);
    any_pressed_ = any_creeps_ = false;
    std::uint64_t pressed = 0;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        Mover& mover = movers_[i];
        if (!flying_[i].pressed || mover.lost) continue;
        ++pressed;
        if (flying_[i].creeps && !mover.crushed && mover.way.until > time) {
            any_pressed_ = any_creeps_ = true;
            continue;
        }
        if (regular) mover.crushed = false;
        mover.waits = flying_[i].creeps = false;
        move_to(i, time);
        members_.push_back(i);
    }
    record_->statistics.handed_over = std::max(record_->statistics.handed_over, pressed);
    const double duration = next_tick_ - time;
    if (members_.empty() || !(duration > 0)) return;
    let_creep(time);
    if (!members_.empty()) {
        solve_members(time, duration);
        for (BallIndex k = 0; k < members_.size(); ++k) hop(members_[k], time, contact_solver_.bodies()[k]);
    }
    std::ranges::copy_if(creeping_, std::back_inserter(members_),
                         [&](BallIndex i) { return flying_[i].creeps; });
    store_forces();
    if (time > 0) predict_together(members_, time);
}

/// Solves the contacts of all members, over a tick of this length.
void ContinuousSolver::solve_members(double time, double duration) {
    for (const BallIndex i : members_) flying_[i].solved = true;
    take_in_pushed(time);
    gather(time, duration);
    while (!overlapped_.empty()) {
        for (const BallIndex j : overlapped_) take_in(j, time);
        gather(time, duration);
    }
    contact_solver_.solve(duration, scene_.gravity);
    if (record_->trace) trace_tick(time, duration);
    note_forces(time, duration);
    for (const BallIndex i : members_) flying_[i].solved = false;
}

/// At the points of a coarser grid all members are solved over a long tick. Those that hardly move in it,
/// before and after, creep on through it; all others take short ticks.
void ContinuousSolver::let_creep(double time) {
    const double until = next_on_grid(time, long_tick_length), duration = until - time;
    const bool on_grid = time == 0 || std::abs(until - time - long_tick_length) < 1e-3 * tick_length;
    if (!on_grid || duration < 1.5 * tick_length) return;
    const auto may_creep = [&](BallIndex i) {
        return !movers_[i].crushed && creeps_at(length(bodies_[i].velocity), bodies_[i]);
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(members_, may_creep));
    if (creeping_share * count < members_.size()) return;
    solve_members(time, duration);
    std::size_t kept = 0;
    for (BallIndex k = 0; k < members_.size(); ++k) {
        const BallIndex i = members_[k];
        const ContactSolver::Body& body = contact_solver_.bodies()[k];
        if (may_creep(i) && creeps_at(length(body.velocity), bodies_[i]) && movers_[i].loaded_at == time) {
            creep(i, time, until, body);
            creeping_.push_back(i);
        } else {
            members_[kept++] = i;
        }
    }
    members_.resize(kept);
    any_creeps_ = !creeping_.empty();
}

/// Makes a ball a member that is solved now.
void ContinuousSolver::take_in(BallIndex i, double time) {
    if (flying_[i].solved) return;
    move_to(i, time);
    join(i, time);
    flying_[i].creeps = false;
    flying_[i].solved = true;
    members_.push_back(i);
}

/// What creeps and is pushed by a member, faster than it may creep, creeps no more.
void ContinuousSolver::take_in_pushed(double time) {
    if (!any_creeps_) return;
    for (std::size_t seen = 0; seen < members_.size();) {
        const BallIndex i = members_[seen++];
        const Ball& ball = bodies_[i];
        cells_.each_near(i, [&](BallIndex j) {
            if (!flying_[j].creeps || !layers_meet(ball, bodies_[j])) return;
            const Ball& other = bodies_[j];
            const Vec2 between = ball.position - movers_[j].way.path.position(time);
            const double distance = length(between), gap = distance - ball.radius - other.radius;
            const double near = press_distance * std::min(ball.radius, other.radius);
            const double closing = -dot(ball.velocity - other.velocity, between) / distance;
            if (gap < -near || (gap < near + slow_ * tick_length && !creeps_at(closing, other)))
                take_in(j, time);
        });
    }
}

/// The bodies of all members, and the contacts that may press within the tick.
void ContinuousSolver::gather(double time, double duration) {
    std::ranges::sort(members_);
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
    ball_forces_.start(), part_forces_.start();
    for (const BallIndex i : members_) {
        ball_forces_.go_on_to(i);
        cells_.each_near(i, [&](BallIndex j) { press_balls(i, j, time, duration); });
    }
    for (const BallIndex i : members_) {
        part_forces_.go_on_to(i);
        press_parts(i, time, duration);
    }
}

/// Adds two balls that are in touch or will be, slowly; a fast approach is an event.
void ContinuousSolver::press_balls(BallIndex i, BallIndex j, double time, double duration) {
    const Ball &a = bodies_[i], &b = bodies_[j];
    ++record_->statistics.pair_tests;
    const Flying& flying = flying_[j];
    if (!flying.meets || (flying.solved && j > i)) return;
    const bool flies = !b.asleep && !flying.pressed, creeps = flying.creeps;
    const Vec2 there = flies || creeps ? movers_[j].way.path.position(time) : b.position;
    const Vec2 between = a.position - there;
    const double reach = a.radius + b.radius,
                 slack = slow_ * duration + press_distance * std::min(a.radius, b.radius);
    const double square = length_squared(between);
    if (square >= (reach + slack) * (reach + slack) || square == 0 || !layers_meet(a, b)) return;
    const double distance = std::sqrt(square), gap = distance - reach;
    const Vec2 normal = between / distance;
    const bool deep = gap < -press_distance * std::min(a.radius, b.radius);
    const Vec2 other_velocity = b.asleep ? Vec2{} : b.velocity;
    const double closing = -dot(a.velocity - other_velocity, normal);
    if (flies) {
        if (deep) overlapped_.push_back(j);
        return;
    }
    deepest_ = std::max(deepest_, -gap);
    const bool crushed = movers_[i].crushed || movers_[j].crushed;
    if (!deep && !crushed && closing > slow_) return;
    ++record_->statistics.narrow_tests;
    ++record_->statistics.contacts;
    const bool i_above = dot(normal, scene_.gravity) <= 0;
    ContactSolver::Contact contact;
    const auto other = flying_[j].solved ? rank_[j] : contact_solver_.add({there, {}, {}, 0, b.radius, 0, 0});
    contact.upper = i_above ? rank_[i] : other;
    contact.lower = i_above ? other : rank_[i];
    contact.normal = i_above ? normal : -normal;
    contact.gap_found = gap;
    contact.friction = layout_.mixed(a.material, b.material).friction;
    contact.height = -dot(a.position + there, scene_.gravity);
    contact.a = std::min(i, j), contact.b = std::max(i, j);
    press(contact, ball_forces_, duration);
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

void ContinuousSolver::press_parts(BallIndex i, double time, double duration) {
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
        contact.a = seen, contact.b = i;
        press(contact, part_forces_, duration);
    }
}

/// Remembers the forces on members, and who is pressed: by a ball, or from two sides.
void ContinuousSolver::note_forces(double time, double duration) {
    const auto members = static_cast<BallIndex>(members_.size());
    // What bears a ball that creeps is found anew with it.
    ball_forces_.forget_if([&](const ContactForce& force) {
        const bool creep_a = flying_[force.a].creeps, creep_b = flying_[force.b].creeps;
        return !(creep_a && (creep_b || bodies_[force.b].asleep)) && !(creep_b && bodies_[force.a].asleep);
    });
    part_forces_.forget_if([&](const ContactForce& force) { return !flying_[force.b].creeps; });
    for (const BallIndex i : members_) movers_[i].sides = 0;
    for (const ContactSolver::Contact& contact : contact_solver_.contacts()) {
        if (contact.impulse.normal <= 0) continue;
        const auto bear = [&](BallIndex body, int sides) {
            if (body >= members) return;
            Mover& mover = movers_[members_[body]];
            if ((mover.sides += sides) >= 2) mover.loaded_at = time;
        };
        bear(contact.upper, contact.with == ContactSolver::With::ball ? 2 : 1);
        bear(contact.lower, contact.with == ContactSolver::With::ball ? 2 : 0);
        (contact.with == ContactSolver::With::ball ? ball_forces_ : part_forces_)
            .add({contact.a, contact.b, contact.impulse.normal / duration,
                  contact.impulse.tangent / duration});
    }
    ball_forces_.settle(), part_forces_.settle();
}

/// Writes the forces between balls where a saved state finds them.
void ContinuousSolver::store_forces() {
    std::vector<ContactForce>& known = table_->memory().forces;
    known.clear();
    for (const ContactForce& force : ball_forces_.all())
        known.push_back({movers_[force.a].number, movers_[force.b].number, force.normal, force.tangent});
}

}  // namespace flipside::custom
