#include "custom/discrete/pile.hpp"

#include <algorithm>
#include <cmath>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

namespace {

/// Rounds over all contacts of a flight.
constexpr int most_rounds = 40;
/// Rounds end when none changes a speed by more than this part of what gravity gives in the flight.
constexpr double close_enough = 1e-3;
/// Passes that take out overlap, and the part of it that each takes: all of it at once and the balls of a
/// dense pile would push each other to and fro.
constexpr int most_passes = 12;
constexpr double pass_share = 0.4;
/// Overlap that stays, in radii: contacts that press are kept in touch.
constexpr double slop = 5e-4;

}  // namespace

void Pile::reserve(std::size_t balls) {
    make_room(members_, balls);
    make_room(places_, balls);
    make_room(bodies_, balls, 1 + contacts_per_ball);
    make_room(grounds_, balls, contacts_per_ball);
    for (auto* list : {&added_, &contacts_}) make_room(*list, balls, contacts_per_ball);
    make_room(directions_, balls, contacts_per_ball);
    make_room(impulses_, balls, contacts_per_ball);
    make_room(positions_, balls);
    make_room(heights_, balls, contacts_per_ball);
}

void Pile::start(std::span<Ball> balls, Vec2 gravity, double duration) {
    balls_ = balls;
    gravity_ = gravity;
    duration_ = duration;
    members_.resize(balls.size());
    places_.clear();
    bodies_.clear();
    grounds_.clear();
    added_.clear();
    impulses_.clear();
}

void Pile::join(std::uint32_t place) {
    const Ball& ball = balls_[place];
    members_[place] = static_cast<Index>(places_.size());
    places_.push_back(place);
    bodies_.push_back({ball.velocity, ball.spin, ball.radius, ball.asleep ? 0 : 1 / ball.mass,
                       ball.asleep ? 0 : 1 / inertia(ball)});
}

void Pile::add(std::uint32_t place, const Touch& touch, Vec2 surface, double friction) {
    const Index member = members_[place];
    const Body& ball = bodies_[member];
    if (ball.per_mass == 0) return;
    const auto part = static_cast<Index>(bodies_.size());
    const double rim = ball.per_mass + ball.radius * ball.radius * ball.per_inertia;
    added_.push_back({member,
                      part,
                      static_cast<Index>(added_.size()),
                      touch.normal,
                      std::max(0.0, touch.separation) / duration_,
                      friction,
                      1 / ball.per_mass,
                      1 / rim,
                      {}});
    bodies_.push_back({surface});
    grounds_.push_back({balls_[place].position, touch.separation});
}

void Pile::add(std::uint32_t a, std::uint32_t b, double friction, const Impulse& begin) {
    const Body &first = bodies_[members_[a]], &second = bodies_[members_[b]];
    const double per_mass = first.per_mass + second.per_mass;
    const Vec2 between = balls_[a].position - balls_[b].position;
    const double gap = length(between) - first.radius - second.radius;
    const double rim = per_mass + first.radius * first.radius * first.per_inertia +
                       second.radius * second.radius * second.per_inertia;
    added_.push_back({members_[a], members_[b], static_cast<Index>(added_.size()), unit(between),
                      std::max(0.0, gap) / duration_, friction, 1 / per_mass, 1 / rim, begin});
}

/// Puts the contacts in order of height.
void Pile::order() {
    heights_.clear();
    for (Contact& contact : added_) {
        const Ball& ball = balls_[places_[contact.upper]];
        double height = -dot(ball.position, gravity_) - ball.radius * length(gravity_);
        if (contact.lower < places_.size()) {
            const Vec2 lower = balls_[places_[contact.lower]].position;
            height = -0.5 * dot(ball.position + lower, gravity_);
            if (dot(ball.position - lower, gravity_) > 0) {
                std::swap(contact.lower, contact.upper);
                contact.normal = -contact.normal;  // an impulse along it and its perp keeps its numbers
            }
        }
        heights_.push_back({height, contact.number});
    }
    std::ranges::sort(heights_);
    contacts_.clear();
    for (const Height& height : heights_) contacts_.push_back(added_[height.contact]);
}

void Pile::push(const Contact& contact, const Impulse& impulse) {
    Body &a = bodies_[contact.upper], &b = bodies_[contact.lower];
    const Vec2 along = impulse.normal * contact.normal + impulse.tangent * perp(contact.normal);
    a.velocity += a.per_mass * along;
    b.velocity -= b.per_mass * along;
    a.spin -= a.radius * a.per_inertia * impulse.tangent;
    b.spin -= b.radius * b.per_inertia * impulse.tangent;
}

/// One contact made right, were there no others. What changed, in m/s.
double Pile::correct(Contact& contact) {
    const Body &a = bodies_[contact.upper], &b = bodies_[contact.lower];
    const Vec2 relative = a.velocity - b.velocity;
    const double closing = -dot(relative, contact.normal) - contact.allowed;
    const Impulse before = contact.total;
    Impulse& total = contact.total;
    total.normal = std::max(0.0, before.normal + contact.mass * closing);
    if (contact.friction > 0) {
        const double slip = dot(relative, perp(contact.normal)) - a.radius * a.spin - b.radius * b.spin;
        const double limit = contact.friction * total.normal;
        total.tangent = std::clamp(before.tangent - contact.rim_mass * slip, -limit, limit);
    }
    const Impulse change = total - before;
    push(contact, change);
    return std::max(std::abs(change.normal) / contact.mass, std::abs(change.tangent) / contact.rim_mass);
}

double Pile::one_round() {
    double most = 0;
    for (Contact& contact : contacts_) most = std::max(most, correct(contact));
    return most;
}

/// Goes on in the direction of the rounds before, as far as the last one got on (Fletcher and Reeves). When
/// that was farther than the one before, the direction led astray: it is given up.
void Pile::run_on(double& norm_before) {
    double norm = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact& contact = contacts_[i];
        const Impulse step = contact.total - directions_[i].before;
        norm += step.normal * step.normal / contact.mass + step.tangent * step.tangent / contact.rim_mass;
    }
    const bool first = norm_before == 0, astray = norm >= norm_before;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        Direction& direction = directions_[i];
        const Impulse step = contact.total - direction.before;
        if (astray) {
            direction.along = first ? step : Impulse{};
        } else {
            const Impulse further = norm / norm_before * direction.along;
            contact.total = contact.total + further;
            push(contact, further);
            direction.along = step + further;
        }
        direction.before = contact.total;
    }
    norm_before = norm;
}

/// Where contacts still close, stops the upper ball. From below, so that one pass does it for a column.
void Pile::brace() {
    for (const Contact& contact : contacts_) {
        Body& upper = bodies_[contact.upper];
        if (upper.per_mass == 0) continue;
        const Vec2 relative = upper.velocity - bodies_[contact.lower].velocity;
        const double closing = -dot(relative, contact.normal) - contact.allowed;
        if (closing > 0) upper.velocity += closing * contact.normal;
    }
}

void Pile::solve() {
    order();
    directions_.clear();
    for (const Contact& contact : contacts_) {
        push(contact, contact.total);
        directions_.push_back({contact.total, {}});
    }
    const double enough = close_enough * length(gravity_) * duration_;
    double norm = 0;
    for (int round = 1; one_round() > enough && round < most_rounds; ++round) run_on(norm);
    impulses_.resize(contacts_.size());
    for (const Contact& contact : contacts_) impulses_[contact.number] = contact.total;
    brace();
    take_over();
}

/// Gives the balls their velocities and takes out what overlaps.
void Pile::take_over() {
    positions_.clear();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        Ball& ball = balls_[places_[i]];
        const Body& body = bodies_[i];
        ball.position += duration_ / 2 * (body.velocity - ball.velocity);
        ball.angle += duration_ / 2 * (body.spin - ball.spin);
        ball.velocity = body.velocity;
        ball.spin = body.spin;
        positions_.push_back(ball.position);
    }
    separate();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        Ball& ball = balls_[places_[i]];
        const double lift = dot(positions_[i] - ball.position, gravity_);  // J/kg
        if (lift <= 0) continue;
        const double left = length_squared(ball.velocity) - 2 * lift;
        ball.velocity = left > 0 ? std::sqrt(left) * unit(ball.velocity) : Vec2{};
    }
}

void Pile::separate() {
    for (int pass = 0; pass < most_passes; ++pass) {
        bool any = false;
        for (const Contact& contact : contacts_) any = separate(contact) || any;
        if (!any) return;
    }
}

/// False when it overlaps by no more than the slop.
bool Pile::separate(const Contact& contact) {
    Ball& upper = balls_[places_[contact.upper]];
    if (contact.lower >= places_.size()) {
        const Ground& ground = grounds_[contact.lower - places_.size()];
        const double gap = ground.gap + dot(upper.position - ground.position, contact.normal);
        const double deep = -gap - slop * upper.radius;
        if (deep <= 0) return false;
        upper.position += pass_share * deep * contact.normal;
        return true;
    }
    Ball& lower = balls_[places_[contact.lower]];
    const Vec2 between = upper.position - lower.position;
    const double reach = upper.radius + lower.radius - slop * std::min(upper.radius, lower.radius);
    if (length_squared(between) >= reach * reach) return false;
    const Vec2 impulse =
        pass_share * contact.mass * (reach - length(between)) * unit(between, contact.normal);
    upper.position += bodies_[contact.upper].per_mass * impulse;
    lower.position -= bodies_[contact.lower].per_mass * impulse;
    return true;
}

}  // namespace flipside::custom
