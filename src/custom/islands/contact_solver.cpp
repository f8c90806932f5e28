#include "custom/islands/contact_solver.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "custom/broad_phase/capacity.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom {

namespace {

constexpr int least_sweeps = 20, most_sweeps = 400;
/// All sweeps but the first of a batch change an impulse by this times what its contact alone would need
/// (successive over-relaxation, Young 1954). The first solves a lone contact exactly.
constexpr double over_relaxation = 1.5;
/// When the load decreases, the warm-start impulses are too large and could add energy. While the solve has
/// added energy, it is extended by the same number of sweeps, at most this often.
constexpr int most_extensions = 9;
/// Where the position correction leaves overlaps deeper than corrected_overlap, the contacts at most
/// squeezed_reach contacts away get more sweeps. In a row of balls between two walls that has no room for one
/// of them, forces are many times its weight, and the heap above would push it in ever deeper.
constexpr int squeezed_sweeps = 240;
constexpr int squeezed_reach = 3;
/// Over-relaxation there: 2/(1 + sin(π/n)) is best for a row of n contacts, and such a row has about 30.
constexpr double squeezed_relaxation = 1.8;
/// Sweeps there without over-relaxation, with which velocities oscillate where masses differ much.
constexpr int last_sweeps = 60;
/// Sweeps end when none changes a velocity by more than this part of the velocity that gravity gives in a
/// tick.
constexpr double good_enough = 1e-4;
/// The position correction ends when no overlap is greater than allowed_overlap, in radii, or, after more
/// than least_corrections sweeps, than corrected_overlap. Light balls between heavy ones need hundreds.
constexpr int least_corrections = 4, most_corrections = 400;
/// Sweeps of the position correction that move the two bodies of a contact in proportion to their inverse
/// masses. Later ones move both by the same distance: a light ball between heavy ones would only be pushed to
/// and fro.
constexpr int corrections_by_mass = 20;
constexpr double allowed_overlap = 1e-4;
/// Limit on the passes over the contacts with static parts that end a solve. In a wedge of 30 degrees an
/// error decreases by a quarter with each.
constexpr int most_static_passes = 100;

/// Sweeps over so many contacts that take `solves` solves of single contacts in all, from `least` to `most`.
/// A few balls under one of 60 times their mass need hundreds of sweeps, which are cheap there; a heap needs
/// few.
int sweeps_over(std::size_t contacts, int least, int most) {
    constexpr std::size_t solves = 4000;
    return std::clamp(static_cast<int>(solves / std::max<std::size_t>(1, contacts)), least, most);
}

/// m: of the smaller ball of a contact. A part has no radius.
double radius_of(const ContactSolver::Body& upper, const ContactSolver::Body& lower) {
    return lower.radius > 0 ? std::min(upper.radius, lower.radius) : upper.radius;
}

/// Applies an impulse to both bodies of a contact.
void apply(Vec2 normal, const ContactImpulse& impulse, ContactSolver::Body& upper,
           ContactSolver::Body& lower) {
    Vec2 p = impulse.normal * normal;
    if (impulse.tangent != 0) {
        p += impulse.tangent * perp(normal);
        upper.rim_speed -= upper.inverse_rim_mass * impulse.tangent;
        lower.rim_speed -= lower.inverse_rim_mass * impulse.tangent;
    }
    upper.velocity += upper.inverse_mass * p;
    lower.velocity -= lower.inverse_mass * p;
}

}  // namespace

void ContactSolver::reserve(std::size_t balls) {
    reserve_for(bodies_, 2 * balls);
    reserve_for(contacts_, balls, contacts_per_ball);
    reserve_for(uncorrected_, 2 * balls);
    reserve_for(reached_, 2 * balls);
    reserve_for(squeezed_, balls, contacts_per_ball);
    residuals_.reserve(most_sweeps * (most_extensions + 1) + squeezed_sweeps + last_sweeps);
}

/// Changes the impulse of a contact such that it closes no faster than allowed and slips as little as
/// friction allows, times `relaxation`. Returns by how much a velocity has changed, m/s.
double ContactSolver::solve_contact(Contact& contact, double relaxation) {
    Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    const Vec2 relative = upper.velocity - lower.velocity;
    const double apart = dot(relative, contact.normal);
    const ContactImpulse before = contact.impulse;
    contact.impulse.normal =
        std::max(before.normal - relaxation * contact.normal_mass * (apart + contact.max_closing), 0.0);
    if (contact.friction > 0) {
        const double slip = dot(relative, perp(contact.normal)) - upper.rim_speed - lower.rim_speed;
        const double most = contact.friction * contact.impulse.normal;
        contact.impulse.tangent =
            std::max(std::min(before.tangent - relaxation * contact.tangent_mass * slip, most), -most);
    }
    const ContactImpulse change{contact.impulse.normal - before.normal,
                                contact.impulse.tangent - before.tangent};
    apply(contact.normal, change, upper, lower);
    return std::max(std::abs(change.normal), std::abs(change.tangent)) *
           (upper.inverse_mass + lower.inverse_mass);
}

/// Sweeps over these contacts, at most so often, until no velocity changes by more than `enough`, m/s.
/// Returns whether they ended so.
bool ContactSolver::converge(std::span<Contact> contacts, int most, double relaxation, double enough) {
    for (int round = 1;; ++round) {
        double change = 0;
        for (Contact& contact : contacts)
            change = std::max(change, solve_contact(contact, round == 1 ? 1 : relaxation));
        residuals_.push_back(change);
        if (change <= enough) return true;
        if (round == most) return false;
    }
}

/// More sweeps over the contacts near deep overlaps.
void ContactSolver::converge_squeezed(double enough) {
    // Per body: 0, or 1 more than the number of contacts between it and a deep overlap.
    reached_.assign(bodies_.size(), 0);
    const auto reach = [&](Index body, int distance) {
        if (bodies_[body].inverse_mass > 0 && reached_[body] == 0) reached_[body] = distance;
    };
    for (const Contact& contact : contacts_)
        if (-contact.gap > corrected_overlap * radius_of(bodies_[contact.upper], bodies_[contact.lower]))
            reach(contact.upper, 1), reach(contact.lower, 1);
    for (int distance = 1; distance < squeezed_reach; ++distance)
        for (const Contact& contact : contacts_)
            if (reached_[contact.upper] == distance || reached_[contact.lower] == distance)
                reach(contact.upper, distance + 1), reach(contact.lower, distance + 1);
    const auto is_near = [&](const Contact& contact) {
        return reached_[contact.upper] > 0 || reached_[contact.lower] > 0;
    };
    squeezed_.clear();
    std::ranges::copy_if(contacts_, std::back_inserter(squeezed_), is_near);
    if (!converge(squeezed_, squeezed_sweeps, squeezed_relaxation, enough))
        converge(squeezed_, last_sweeps, 1, enough);
    auto solved = squeezed_.begin();
    for (Contact& contact : contacts_)
        if (is_near(contact)) contact = *solved++;
}

/// Stops the upper ball of a contact that still closes too fast. Returns by how much, m/s.
double ContactSolver::propagate_shock(const Contact& contact) {
    Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    const double closing = -dot(upper.velocity - lower.velocity, contact.normal) - contact.max_closing;
    if (closing <= 0) return 0;
    if (upper.inverse_mass > 0)
        upper.velocity += closing * contact.normal;
    else
        lower.velocity -= closing * contact.normal;
    return closing;
}

/// Removes the overlap of a contact, by moving its bodies in proportion to their inverse masses, or equally.
/// Returns its depth, in radii of the smaller ball.
double ContactSolver::correct_position(Contact& contact, bool by_mass) {
    Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
    if (contact.with == With::ball) {
        const Vec2 between = upper.position - lower.position;
        const double distance = length(between);
        if (distance > 0) contact.normal = between / distance;
        contact.gap = distance - upper.radius - lower.radius;
    } else {
        const Vec2 moved = upper.position - uncorrected_[contact.upper];
        contact.gap = contact.detected_gap + dot(moved, contact.normal);
    }
    if (contact.gap >= 0) return 0;
    const auto mobility = [&](const Body& body) {
        return by_mass || body.inverse_mass == 0 ? body.inverse_mass : 1;
    };
    const double share = -contact.gap / (mobility(upper) + mobility(lower));
    upper.position += share * mobility(upper) * contact.normal;
    lower.position -= share * mobility(lower) * contact.normal;
    return -contact.gap / radius_of(upper, lower);
}

/// Corrects the contacts with static parts until no error is greater than `enough`. They come last, so that
/// no ball ends inside a static part. One pass suffices but for a ball in a wedge.
void ContactSolver::repeat_static(double enough, auto&& correct) {
    double error = INFINITY;
    for (int pass = 0; pass < most_static_passes && error > enough; ++pass) {
        error = 0;
        for (Contact& contact : contacts_) {
            if (contact.with != With::still_part) continue;
            const double gap = contact.gap;
            error = std::max(error, correct(contact));
            if (pass > 0) contact.gap = gap;  // converge_squeezed() needs the gap before all passes
        }
    }
}

/// Corrects the positions of overlapping bodies. A ball that is lifted loses the energy from its speed.
/// Returns the deepest overlap that the last sweep found, in radii.
double ContactSolver::correct_positions(Vec2 gravity) {
    uncorrected_.clear();
    for (const Body& body : bodies_) uncorrected_.push_back(body.position);
    const int rounds = sweeps_over(contacts_.size(), least_corrections, most_corrections);
    double deepest = 0;
    for (int round = 0; round < rounds; ++round) {
        deepest = 0;
        for (Contact& contact : contacts_)
            deepest = std::max(deepest, correct_position(contact, round < corrections_by_mass));
        if (deepest <= (round < least_corrections ? allowed_overlap : corrected_overlap)) break;
    }
    limit_corrections();
    repeat_static(corrected_overlap, [&](Contact& contact) { return correct_position(contact, true); });
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Body& body = bodies_[i];
        const double lifted = -dot(body.position - uncorrected_[i], gravity);
        if (const double speed = length_squared(body.velocity); lifted > 0 && speed > 0)
            body.velocity *= std::sqrt(std::max(0.0, 1 - 2 * lifted / speed));
    }
    return deepest;
}

/// Lets no correction move a body farther than twice the deepest overlap before. A light ball between heavy
/// ones would slide out, into neighbours that were too far away to be among the contacts.
void ContactSolver::limit_corrections() {
    double deepest = 0;
    for (const Contact& contact : contacts_) deepest = std::max(deepest, -contact.detected_gap);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Vec2 shift = bodies_[i].position - uncorrected_[i];
        if (const double far = length(shift); far > 2 * deepest)
            bodies_[i].position = uncorrected_[i] + 2 * deepest / far * shift;
    }
}

/// Energy of all moving bodies after `ahead` seconds, J.
double ContactSolver::energy(double ahead, Vec2 gravity) const {
    double sum = 0;
    for (const Body& body : bodies_) {
        if (body.inverse_mass == 0) continue;
        const double speed = 0.5 * length_squared(body.velocity);
        const double turning = 0.5 * body.rim_speed * body.rim_speed / body.inverse_rim_mass;
        sum += (speed - dot(gravity, body.position + ahead * body.velocity)) / body.inverse_mass + turning;
    }
    return sum;
}

void ContactSolver::solve(double duration, Vec2 gravity) {
    // From the lowest to the highest, those with parts before those between balls.
    std::ranges::sort(contacts_, {},
                      [](const Contact& c) { return std::tuple(c.with, c.height, c.lower, c.upper); });
    const bool squeezed = correct_positions(gravity) > corrected_overlap;
    const double energy_before = energy(0, gravity);
    for (Body& body : bodies_) body.velocity += body.external;
    for (Contact& contact : contacts_) {
        Body &upper = bodies_[contact.upper], &lower = bodies_[contact.lower];
        const double inverse_mass = upper.inverse_mass + lower.inverse_mass;
        contact.normal_mass = 1 / inverse_mass;
        contact.tangent_mass = 1 / (inverse_mass + upper.inverse_rim_mass + lower.inverse_rim_mass);
        contact.max_closing = contact.bounces ? INFINITY : std::max(0.0, contact.gap) / duration;
        apply(contact.normal, contact.impulse, upper, lower);
    }
    residuals_.clear();
    const double enough = good_enough * length(gravity) * duration;
    const int sweeps = sweeps_over(contacts_.size(), least_sweeps, most_sweeps);
    for (int extension = 0; extension <= most_extensions; ++extension)
        if (converge(contacts_, sweeps, over_relaxation, enough) ||
            energy(duration, gravity) <= energy_before)
            break;
    if (squeezed) converge_squeezed(enough);
    const double slow = length(gravity) * duration;
    // From the lowest contact up, so that one pass suffices for a column.
    for (const Contact& contact : contacts_) propagate_shock(contact);
    repeat_static(slow, [&](const Contact& contact) { return propagate_shock(contact); });
}

}  // namespace flipside::custom
