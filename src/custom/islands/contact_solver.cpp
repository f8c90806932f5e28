#include "custom/islands/contact_solver.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "custom/broad_phase/capacity.hpp"

namespace flipside::custom {

namespace {

constexpr int least_sweeps = 20, most_sweeps = 400;
/// Corrections of a contact that every island may have: a few balls under one that is 60 times heavier need
/// hundreds of sweeps, which cost nothing, and a heap gets by with few.
constexpr int corrections = 4000;
/// Where the load grows less, the impulses of the last tick are too much, and what the sweeps have not taken
/// back yet adds energy: then as many sweeps follow again, so often at most.
constexpr int most_extensions = 9;
/// Sweeps end when none changes a velocity by more than this, in parts of what gravity gives in a tick.
constexpr double good_enough = 1e-4;
/// Moving apart ends when no overlap is greater than this, in radii.
constexpr int most_moves = 4;
constexpr double overlap_left = 1e-4;

}  // namespace

void ContactSolver::reserve(std::size_t balls) {
    reserve_for(bodies_, 2 * balls);
    reserve_for(contacts_, balls, contacts_per_ball);
    reserve_for(unordered_, balls, contacts_per_ball);
    reserve_for(places_, balls, contacts_per_ball);
    reserve_for(moved_from_, 2 * balls);
    residuals_.reserve(most_sweeps * (most_extensions + 1));
}

/// An impulse along the normal, and one along perp(normal).
void ContactSolver::push(const Contact& contact, const ContactImpulse& impulse) {
    Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    Vec2 p = impulse.normal * contact.normal;
    if (contact.friction > 0) {
        p += impulse.tangent * perp(contact.normal);
        upper.spin -= upper.per_inertia * upper.radius * impulse.tangent;
        lower.spin -= lower.per_inertia * lower.radius * impulse.tangent;
    }
    upper.velocity += upper.per_mass * p;
    lower.velocity -= lower.per_mass * p;
}

/// Makes the contact close no faster than it may, and slip as little as friction allows.
void ContactSolver::correct(Contact& contact) {
    const Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    const Vec2 relative = upper.velocity - lower.velocity;
    const double apart = dot(relative, contact.normal);
    ContactImpulse impulse;
    impulse.normal = std::max(0.0, contact.impulse.normal - contact.mass * (apart + contact.closing));
    if (contact.friction > 0) {
        const double slip = dot(relative, perp(contact.normal)) - upper.radius * upper.spin -
                            (contact.with == With::ball ? lower.radius * lower.spin : 0);
        const double most = contact.friction * impulse.normal;
        impulse.tangent = std::clamp(contact.impulse.tangent - contact.rim_mass * slip, -most, most);
    }
    push(contact, impulse - contact.impulse);
    contact.impulse = impulse;
}

/// Corrects every contact once.
ContactSolver::Progress ContactSolver::sweep() {
    Progress progress;
    for (Contact& contact : contacts_) {
        const ContactImpulse before = contact.impulse;
        correct(contact);
        const ContactImpulse change = contact.impulse - before, step = contact.impulse - contact.before;
        const double velocity =
            std::abs(change.normal) * contact.per_mass + std::abs(change.tangent) * contact.per_rim_mass;
        progress.most = std::max(progress.most, velocity);
        progress.norm +=
            step.normal * step.normal * contact.per_mass + step.tangent * step.tangent * contact.per_rim_mass;
    }
    return progress;
}

/// Goes on in the direction of the sweeps before, as far as the last one got on (Fletcher and Reeves). When
/// that was farther than the one before, the direction led astray: it is given up.
void ContactSolver::extrapolate(double norm, double norm_before) {
    const bool first = norm_before == 0, astray = norm >= norm_before;
    const double share = first || astray ? 0 : norm / norm_before;
    for (Contact& contact : contacts_) {
        const ContactImpulse step = contact.impulse - contact.before;
        if (share > 0) {
            const ContactImpulse further = share * contact.along;
            contact.impulse = contact.impulse + further;
            push(contact, further);
            contact.along = step + further;
        } else {
            contact.along = first ? step : ContactImpulse{};
        }
        contact.before = contact.impulse;
    }
}

/// Where a contact still closes too fast, stops the upper ball.
void ContactSolver::propagate_shock(const Contact& contact) {
    Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    const double closing = -dot(upper.velocity - lower.velocity, contact.normal) - contact.closing;
    if (closing <= 0) return;
    if (upper.per_mass > 0)
        upper.velocity += closing * contact.normal;
    else
        lower.velocity -= closing * contact.normal;
}

/// Returns how deep the overlap was, in radii.
double ContactSolver::move_apart(Contact& contact) {
    Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    if (contact.with == With::ball) {
        const Vec2 between = upper.position - lower.position;
        const double distance = length(between);
        if (distance > 0) contact.normal = between / distance;
        contact.gap = distance - upper.radius - lower.radius;
    } else {
        contact.gap = contact.gap_found + dot(upper.position - contact.found_at, contact.normal);
    }
    if (contact.gap >= 0) return 0;
    const double share = -contact.gap / (upper.per_mass + lower.per_mass);
    upper.position += share * upper.per_mass * contact.normal;
    lower.position -= share * lower.per_mass * contact.normal;
    return -contact.gap / upper.radius;
}

/// Nothing is pressed into a part that stands still: those have the last word.
void ContactSolver::each_still(auto&& visit) {
    for (Contact& contact : contacts_)
        if (contact.with == With::still_part) visit(contact);
}

/// Moves all apart that overlap. A ball that is lifted pays for it with its speed.
void ContactSolver::move_apart(Vec2 gravity) {
    moved_from_.clear();
    for (const Body& body : bodies_) moved_from_.push_back(body.position);
    for (Contact& contact : contacts_) contact.found_at = bodies_[contact.upper].position;
    for (int round = 0; round < most_moves; ++round) {
        double deepest = 0;
        for (Contact& contact : contacts_) deepest = std::max(deepest, move_apart(contact));
        if (deepest <= overlap_left) break;
    }
    each_still([&](Contact& contact) { move_apart(contact); });
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Body& body = bodies_[i];
        const double lifted = -dot(body.position - moved_from_[i], gravity);
        if (const double speed = length_squared(body.velocity); lifted > 0 && speed > 0)
            body.velocity *= std::sqrt(std::max(0.0, 1 - 2 * lifted / speed));
    }
}

/// Of all that moves, `ahead` seconds on, J.
double ContactSolver::energy(double ahead, Vec2 gravity) const {
    double sum = 0;
    for (const Body& body : bodies_) {
        if (body.per_mass == 0) continue;
        const double speed = 0.5 * length_squared(body.velocity);
        const double turning = 0.5 * body.spin * body.spin / body.per_inertia;
        sum += (speed - dot(gravity, body.position + ahead * body.velocity)) / body.per_mass + turning;
    }
    return sum;
}

/// From the lowest to the highest, those with parts before those of balls.
void ContactSolver::put_in_order() {
    places_.clear();
    for (const Contact& c : contacts_)
        places_.push_back({c.with, c.lower, c.upper, static_cast<Index>(places_.size()), c.height});
    std::ranges::sort(places_, {},
                      [](const Place& p) { return std::tuple(p.with, p.height, p.lower, p.upper); });
    std::swap(contacts_, unordered_);
    contacts_.clear();
    for (const Place& place : places_) contacts_.push_back(unordered_[place.at]);
}

void ContactSolver::solve(double duration, Vec2 gravity) {
    put_in_order();
    move_apart(gravity);
    const double energy_before = energy(0, gravity);
    for (Body& body : bodies_) body.velocity += body.driven;
    for (Contact& contact : contacts_) {
        const Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
        contact.per_mass = upper.per_mass + lower.per_mass;
        contact.per_rim_mass = contact.per_mass + upper.per_inertia * upper.radius * upper.radius +
                               lower.per_inertia * lower.radius * lower.radius;
        contact.mass = 1 / contact.per_mass;
        contact.rim_mass = 1 / contact.per_rim_mass;
        contact.closing = contact.bounces ? INFINITY : std::max(0.0, contact.gap) / duration;
        contact.before = contact.impulse;
        contact.along = {};
        push(contact, contact.impulse);
    }
    residuals_.clear();
    const double enough = good_enough * length(gravity) * duration;
    const int sweeps =
        std::clamp(corrections / std::max(1, static_cast<int>(contacts_.size())), least_sweeps, most_sweeps);
    for (int extension = 0; extension <= most_extensions; ++extension) {
        double norm_before = 0;
        int round = 0;
        for (;;) {
            const Progress progress = sweep();
            residuals_.push_back(progress.most);
            if (progress.most <= enough || ++round == sweeps) break;
            extrapolate(progress.norm, norm_before);
            norm_before = progress.norm;
        }
        if (round < sweeps || energy(duration, gravity) <= energy_before) break;
    }
    // From below, so that one pass does it for a column.
    for (const Contact& contact : contacts_) propagate_shock(contact);
    each_still([&](const Contact& contact) { propagate_shock(contact); });
}

}  // namespace flipside::custom
