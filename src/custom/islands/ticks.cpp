// Ticks: all contacts of the members are collected and solved together.

#include <algorithm>
#include <cmath>

#include "custom/broad_phase/capacity.hpp"
#include "custom/geometry/narrow_phase.hpp"
#include "custom/islands/islands.hpp"
#include "custom/trace/continuous_trace.hpp"

namespace flipside::custom {

namespace {

/// The long tick is solved only if at least one member in this many may creep; for fewer it costs more than
/// it saves.
constexpr std::size_t members_per_creeping = 4;

}  // namespace

void Islands::reserve(std::size_t balls) {
    part_forces_.reserve(balls * contacts_per_ball);
    ball_forces_.reserve(balls * contacts_per_ball);
    contact_solver_.reserve(balls);
    reserve_for(members_, balls);
    reserve_for(creeping_, balls);
    reserve_for(beside_, balls, contacts_per_ball);
    if (rank_.size() < balls) rank_.resize(balls);
}

void Islands::start_window() {
    part_forces_.clear(), ball_forces_.clear();
    find_members();
    solve(0);
}

void Islands::tick(double time) {
    solve(time);
    predictions_.predict(members_, time);
}

/// Solves the contacts of all members and starts their paths until the next tick, without their next events.
/// Members without a load leave the island. Creeping members are solved at every fourth tick; in between they
/// are static obstacles.
void Islands::solve(double time) {
    members_.clear(), creeping_.clear();
    const double off_grid = std::abs(std::remainder(sim_.end - time, sim_.tick_length));
    const bool regular = time == sim_.tick_at && off_grid < 1e-3 * sim_.tick_length;
    sim_.tick_at = sim_.next_tick(time);
    sim_.any_in_island = any_creeps_ = false;
    for (BallIndex i = 0; i < sim_.particles.size(); ++i) {
        Particle& particle = sim_.particles[i];
        if (!sim_.hot[i].in_island || sim_.hot[i].lost) continue;
        if ((particle.frozen || (sim_.hot[i].creeps && !particle.jammed)) && particle.motion.until > time) {
            // A frozen ball may be held for less than a tick.
            sim_.tick_at = std::min(sim_.tick_at, particle.motion.until);
            sim_.any_in_island = true;
            any_creeps_ = any_creeps_ || sim_.hot[i].creeps;
            continue;
        }
        if (regular) particle.jammed = false;
        particle.frozen = sim_.hot[i].creeps = false;
        sim_.advance_to(i, time);
        members_.push_back(i);
    }
    const double duration = sim_.tick_at - time;
    if (!sim_.any_in_island && members_.empty()) {
        ball_forces_.clear(), part_forces_.clear();
        return store_forces();
    }
    if (members_.empty() || !(duration > 0)) return members_.clear();
    start_creep(time);
    if (!members_.empty()) {
        solve_members(time, duration);
        for (BallIndex k = 0; k < members_.size(); ++k)
            start_tick_path(members_[k], time, contact_solver_.bodies()[k]);
    }
    std::ranges::copy_if(creeping_, std::back_inserter(members_),
                         [&](BallIndex i) { return sim_.hot[i].creeps; });
    store_forces();
}

/// Solves the contacts of all members over a tick of this duration, s. Flying balls into which the position
/// correction moves members become members too.
void Islands::solve_members(double time, double duration) {
    for (const BallIndex i : members_) sim_.hot[i].in_solve = true;
    stop_pushed_creep(time);
    do {
        collect_contacts(time, duration);
        contact_solver_.solve(duration, sim_.scene.gravity);
    } while (join_overlapped(time));
    if (sim_.record->trace) trace_tick(sim_, contact_solver_, members_, time, duration);
    remember_forces(time, duration);
    for (const BallIndex i : members_) sim_.hot[i].in_solve = false;
}

/// At the start of a long tick, solves all members over it. Members that are slow before and after this solve
/// creep until its end; all others are solved again over short ticks.
void Islands::start_creep(double time) {
    const double until = sim_.next_on_grid(time, sim_.long_tick_length()), duration = until - time;
    const bool on_grid =
        time == 0 || std::abs(until - time - sim_.long_tick_length()) < 1e-3 * sim_.tick_length;
    if (!on_grid || duration < 1.5 * sim_.tick_length) return;
    const auto may_creep = [&](BallIndex i) {
        return !sim_.particles[i].jammed && sim_.creeps_at(length(sim_.balls[i].velocity), sim_.balls[i]);
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(members_, may_creep));
    if (members_per_creeping * count < members_.size()) return;
    solve_members(time, duration);
    std::size_t kept = 0;
    for (BallIndex k = 0; k < members_.size(); ++k) {
        const BallIndex i = members_[k];
        const ContactSolver::Body& body = contact_solver_.bodies()[k];
        if (may_creep(i) && sim_.creeps_at(length(body.velocity), sim_.balls[i]) &&
            sim_.particles[i].last_loaded == time) {
            start_creep_path(i, time, until, body);
            creeping_.push_back(i);
        } else {
            members_[kept++] = i;
        }
    }
    members_.resize(kept);
    any_creeps_ = !creeping_.empty();
}

/// Adds a ball to the members of the current solve.
void Islands::add_member(BallIndex i, double time) {
    if (sim_.hot[i].in_solve) return;
    sim_.advance_to(i, time);
    sim_.join_island(i, time);
    sim_.hot[i].creeps = false;
    sim_.hot[i].in_solve = true;
    members_.push_back(i);
}

/// Adds each creeping member that a member of this solve pushes faster than it may creep.
void Islands::stop_pushed_creep(double time) {
    if (!any_creeps_) return;
    sim_.cells.flood_fill(members_, [&](BallIndex i, BallIndex j) {
        const Ball &ball = sim_.balls[i], &other = sim_.balls[j];
        if (!sim_.hot[j].creeps || !layers_meet(ball, other)) return;
        const Vec2 between = ball.position - sim_.particles[j].motion.path.position(time);
        const double distance = length(between), gap = distance - ball.radius - other.radius;
        const double near = resting_distance * std::min(ball.radius, other.radius);
        const double closing = -dot(ball.velocity - other.velocity, between) / distance;
        if (gap < -near || (gap < near + sim_.slow * sim_.tick_length && !sim_.creeps_at(closing, other)))
            add_member(j, time);
    });
}

/// Collects the bodies of all members, and the contacts that may carry a force within the tick.
void Islands::collect_contacts(double time, double duration) {
    std::ranges::sort(members_);
    contact_solver_.start();
    const TimeInterval interval(sim_.external.drag, duration);
    for (const BallIndex i : members_) {
        const Ball& ball = sim_.balls[i];
        const Vec2 external = interval.velocity(ball.velocity, sim_.external.gravity) - ball.velocity;
        rank_[i] =
            contact_solver_.add({ball.position, ball.velocity, external, ball.spin * ball.radius, ball.radius,
                                 1 / ball.mass, ball.radius * ball.radius / inertia(ball)});
    }
    deepest_ = 0;
    beside_.clear();
    for (const BallIndex i : members_)
        sim_.cells.query_neighbours(i, [&](BallIndex j) { add_ball_contact(i, j, time, duration); });
    if (!sim_.table.moving_parts().empty())
        for (const BallIndex i : members_) deepest_ = std::max(deepest_, overlap_with_moving_parts(i, time));
    for (const BallIndex i : members_) add_part_contacts(i, time, duration);
}

/// Adds the flying balls into which the position correction has moved members. Returns whether there are any.
bool Islands::join_overlapped(double time) {
    const std::size_t before = members_.size();
    for (const auto& [member, ball] : beside_) {
        const ContactSolver::Body& body = contact_solver_.bodies()[rank_[member]];
        const double radius = sim_.balls[ball].radius;
        const Vec2 position = sim_.particles[ball].motion.path.position(time);
        const double deep = body.radius + radius - corrected_overlap * std::min(body.radius, radius);
        if (length_squared(body.position - position) < deep * deep) add_member(ball, time);
    }
    return members_.size() > before;
}

/// Adds the contact of two balls that touch or may touch within the tick.
void Islands::add_ball_contact(BallIndex i, BallIndex j, double time, double duration) {
    const Ball &a = sim_.balls[i], &b = sim_.balls[j];
    ++sim_.record->statistics.pair_tests;
    const HotState& hot = sim_.hot[j];
    if (hot.in_solve && j > i) return;
    const bool flies = !b.asleep && !hot.in_island;
    const Vec2 there = flies || hot.creeps ? sim_.particles[j].motion.path.position(time) : b.position;
    const Vec2 between = a.position - there;
    const double reach = a.radius + b.radius, near = resting_distance * std::min(a.radius, b.radius),
                 slack = sim_.slow * duration + near, square = length_squared(between);
    if (square >= (reach + slack) * (reach + slack) || !layers_meet(a, b)) return;
    if (flies) {
        beside_.emplace_back(i, j);
        return;
    }
    const double distance = std::sqrt(square), gap = distance - reach;
    const Vec2 normal = distance > 0 ? between / distance : Vec2{0, 1};  // of balls at one point: any
    const double closing = -dot(a.velocity - (b.asleep ? Vec2{} : b.velocity), normal);
    deepest_ = std::max(deepest_, -gap);
    const bool jammed = sim_.particles[i].jammed || sim_.particles[j].jammed;
    ++sim_.record->statistics.narrow_tests;
    const bool i_above = dot(normal, sim_.scene.gravity) <= 0;
    const BallIndex own = rank_[i],
                    other = hot.in_solve ? rank_[j] : contact_solver_.add({there, {}, {}, 0, b.radius, 0, 0});
    add_contact({.upper = i_above ? own : other,
                 .lower = i_above ? other : own,
                 .bounces = gap >= -near && !jammed && closing > sim_.slow,
                 .normal = i_above ? normal : -normal,
                 .friction = sim_.layout.mixed(a, b).friction,
                 .detected_gap = gap,
                 .height = -dot(a.position + there, sim_.scene.gravity),
                 .a = std::min(i, j),
                 .b = std::max(i, j)},
                ball_forces_, duration);
}

/// Adds a contact with its warm-start impulse: the force of the previous tick times the duration.
void Islands::add_contact(ContactSolver::Contact contact, const ForceCache& known, double duration) {
    if (const ContactForce* force = known.find(contact.a, contact.b)) {
        contact.impulse.normal = force->normal * duration;
        contact.impulse.tangent = force->tangent * duration;
    }
    ++sim_.record->statistics.contacts;
    contact_solver_.add(contact);
}

/// Depth of the deepest overlap of a ball with a moving part, m.
double Islands::overlap_with_moving_parts(BallIndex i, double time) {
    const Ball& ball = sim_.balls[i];
    const Box box = bounds_of(ball.position, ball.radius);
    double deepest = 0;
    for (const PrimitiveIndex near : gates_.primitives_near(box, ball)) {
        const Primitive& primitive = sim_.layout.primitive(near);
        const Turning& turning = sim_.turnings[primitive.part];
        if (turning.still()) continue;
        const Touch found = touch(ball.position, ball.radius, primitive, turning.pose(time));
        if (!found.past_end) deepest = std::max(deepest, -found.separation);
    }
    return deepest;
}

void Islands::add_part_contacts(BallIndex i, double time, double duration) {
    const Ball& ball = sim_.balls[i];
    // Includes the parts into which the position correction of overlaps could push this ball.
    const double slack = sim_.slow * duration + resting_distance * ball.radius + 2 * deepest_;
    const Box box = bounds_of(ball.position, ball.radius + slack);
    for (const PrimitiveIndex near : gates_.primitives_near(box, ball)) {
        const Primitive& primitive = sim_.layout.primitive(near);
        const Turning& turning = sim_.turnings[primitive.part];
        const Pose pose = turning.pose(time);
        if (!sim_.layout.should_collide(sim_.table, near, pose, ball)) continue;
        ++sim_.record->statistics.narrow_tests;
        const Touch found = touch(ball.position, ball.radius, primitive, pose);
        if (found.past_end || found.separation > slack) continue;
        const Vec2 surface = turning.velocity_at(found.point, time);
        const double closing = -dot(ball.velocity - surface, found.normal);
        const bool moves = turning.rate_at(time) != 0;
        add_contact({.upper = rank_[i],
                     .lower = contact_solver_.add({found.point, surface, {}, 0, 0, 0, 0}),
                     .with = moves ? ContactSolver::With::moving_part : ContactSolver::With::still_part,
                     .bounces = !sim_.particles[i].jammed &&
                                found.separation > -resting_distance * ball.radius && closing > sim_.slow,
                     .normal = found.normal,
                     .friction = sim_.layout.mixed(ball, sim_.scene.parts[primitive.part]).friction,
                     .detected_gap = found.separation,
                     .height = -2 * dot(found.point, sim_.scene.gravity),
                     .a = near,
                     .b = i},
                    part_forces_, duration);
    }
}

/// Stores the forces for the next tick, and notes which members have a load: from a ball, or from two sides.
void Islands::remember_forces(double time, double duration) {
    // Forces on creeping members stay until these are solved again.
    ball_forces_.forget_if([&](const ContactForce& force) {
        const bool creep_a = sim_.hot[force.a].creeps, creep_b = sim_.hot[force.b].creeps;
        return !(creep_a && (creep_b || sim_.balls[force.b].asleep)) &&
               !(creep_b && sim_.balls[force.a].asleep);
    });
    part_forces_.forget_if([&](const ContactForce& force) { return !sim_.hot[force.b].creeps; });
    for (const BallIndex i : members_) sim_.particles[i].loads = 0;
    // The impulse that stops a jammed ball acts at one instant. As a force over the rest of a tick, in which
    // the ball jams, it would add energy as the start of the next solve.
    const auto may_be_impact = [&](const ContactSolver::Contact& contact) {
        const auto jammed = [&](ContactSolver::Index body) {
            return body < members_.size() && sim_.particles[members_[body]].jammed;
        };
        return jammed(contact.upper) || jammed(contact.lower);
    };
    for (const ContactSolver::Contact& contact : contact_solver_.contacts()) {
        if (contact.impulse.normal <= 0) continue;
        const bool of_balls = contact.with == ContactSolver::With::ball;
        for (const BallIndex body : {contact.upper, contact.lower}) {
            if (body >= members_.size()) continue;
            Particle& particle = sim_.particles[members_[body]];
            if ((particle.loads += of_balls ? 2 : 1) >= 2) particle.last_loaded = time;
        }
        const double lasts = may_be_impact(contact) ? std::max(duration, sim_.tick_length) : duration;
        (of_balls ? ball_forces_ : part_forces_)
            .add({contact.a, contact.b, contact.impulse.normal / lasts, contact.impulse.tangent / lasts});
    }
    ball_forces_.merge(), part_forces_.merge();
}

/// Writes the forces between balls into the engine's memory, which saved states contain.
void Islands::store_forces() {
    std::vector<ContactForce>& known = sim_.table.memory().forces;
    known.clear();
    for (const ContactForce& force : ball_forces_.all())
        known.push_back(
            {sim_.balls[force.a].number, sim_.balls[force.b].number, force.normal, force.tangent});
}

}  // namespace flipside::custom
