#include "custom/islands/contact_solver.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "custom/broad_phase/room.hpp"

namespace flipside::custom {

namespace {

constexpr int most_sweeps = 20;
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
    make_room(bodies_, 2 * balls);
    make_room(contacts_, balls, contacts_per_ball);
    make_room(moved_from_, 2 * balls);
}

void ContactSolver::push(const Contact& contact, const ContactImpulse& impulse) {
    Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    const Vec2 p = impulse.normal * contact.normal + impulse.tangent * perp(contact.normal);
    upper.velocity += upper.per_mass * p;
    lower.velocity -= lower.per_mass * p;
    upper.spin -= upper.per_inertia * upper.radius * impulse.tangent;
    lower.spin -= lower.per_inertia * lower.radius * impulse.tangent;
}

/// Returns how much it changed a velocity, m/s.
double ContactSolver::correct(Contact& contact) {
    const Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    const Vec2 relative = upper.velocity - lower.velocity;
    const double apart = dot(relative, contact.normal);
    const double normal = std::max(0.0, contact.impulse.normal - contact.mass * (apart + contact.closing));
    ContactImpulse change{normal - contact.impulse.normal, 0};
    if (contact.friction > 0) {
        const double slip = dot(relative, perp(contact.normal)) - upper.radius * upper.spin -
                            (contact.with == With::ball ? lower.radius * lower.spin : 0);
        const double most = contact.friction * normal;
        const double tangent = std::clamp(contact.impulse.tangent - contact.rim_mass * slip, -most, most);
        change.tangent = tangent - contact.impulse.tangent;
        contact.impulse.tangent = tangent;
    }
    contact.impulse.normal = normal;
    push(contact, change);
    return std::abs(change.normal) / contact.mass + std::abs(change.tangent) / contact.rim_mass;
}

/// Returns the greatest change of a velocity, m/s.
double ContactSolver::sweep() {
    double most = 0;
    for (Contact& contact : contacts_) most = std::max(most, correct(contact));
    return most;
}

/// Goes on in the direction of the sweeps before, as far as the last one got on (Fletcher and Reeves). When
/// that was farther than the one before, the direction led astray: it is given up.
void ContactSolver::run_on(double& norm_before) {
    double norm = 0;
    for (const Contact& contact : contacts_) {
        const ContactImpulse step = contact.impulse - contact.before;
        norm += step.normal * step.normal / contact.mass + step.tangent * step.tangent / contact.rim_mass;
    }
    const bool first = norm_before == 0, astray = norm >= norm_before;
    for (Contact& contact : contacts_) {
        const ContactImpulse step = contact.impulse - contact.before;
        if (astray) {
            contact.along = first ? step : ContactImpulse{};
        } else {
            const ContactImpulse further = norm / norm_before * contact.along;
            contact.impulse = contact.impulse + further;
            push(contact, further);
            contact.along = step + further;
        }
        contact.before = contact.impulse;
    }
    norm_before = norm;
}

/// Where a contact still closes too fast, stops the upper ball.
void ContactSolver::brace(const Contact& contact) {
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

void ContactSolver::solve(double duration, Vec2 gravity) {
    std::ranges::sort(contacts_, {},
                      [](const Contact& c) { return std::tuple(c.with, c.height, c.lower, c.upper); });
    move_apart(gravity);
    const double energy_before = energy(0, gravity);
    for (Body& body : bodies_) body.velocity += body.driven;
    for (Contact& contact : contacts_) {
        const Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
        contact.mass = 1 / (upper.per_mass + lower.per_mass);
        contact.rim_mass =
            1 / (upper.per_mass + lower.per_mass + upper.per_inertia * upper.radius * upper.radius +
                 lower.per_inertia * lower.radius * lower.radius);
        contact.closing = contact.bounces ? INFINITY : std::max(0.0, contact.gap) / duration;
        contact.before = contact.impulse;
        contact.along = {};
        push(contact, contact.impulse);
    }
    const double enough = good_enough * length(gravity) * duration;
    for (int extension = 0; extension <= most_extensions; ++extension) {
        double norm = 0;
        int round = 0;
        while (sweep() > enough && ++round < most_sweeps) run_on(norm);
        if (round < most_sweeps || energy(duration, gravity) <= energy_before) break;
    }
    // From below, so that one pass does it for a column.
    for (const Contact& contact : contacts_) brace(contact);
    each_still([&](const Contact& contact) { brace(contact); });
}

}  // namespace flipside::custom
