#include <limits>

#include "checker.hpp"

namespace certificate {

/// Acceleration that is neither gravity nor drag: what a surface does.
JetVec Checker::force_at(const I& t) const {
    const JetVec v = velocity_of(motion_of(leg(), t));
    return {v.x.derivative() - I(run_.gravity[0]) + I(run_.damping) * v.x,
            v.y.derivative() - I(run_.gravity[1]) + I(run_.damping) * v.y};
}

void Checker::check_motion() {
    const Leg& now = leg();
    if (now.held.empty()) {
        stays_zero("flies by the equation of motion", acceleration_,
                   [&](const I& t) { return force_at(t).x; });
        stays_zero("flies by the equation of motion", acceleration_,
                   [&](const I& t) { return force_at(t).y; });
        stays_zero("spin stays in flight", acceleration_ / ball_->radius,
                   [&](const I& t) { return motion_of(now, t).spin.derivative(); });
        return;
    }
    ++verdict_.held;
    std::vector<const Feature*> on;
    for (const std::size_t primitive : now.held) {
        const Feature& f = *on.emplace_back(&held_on(primitive));
        stays_zero("stays in contact", ball_->radius, [&](const I& t) { return lie(primitive, f, t).gap; });
    }
    on.size() == 1 ? check_one_contact(*on[0]) : check_two_contacts(on);
}

const Span* Checker::span_of(std::size_t primitive) const {
    return span_at(part_of(primitive), std::nextafter(leg().start, std::numeric_limits<double>::infinity()));
}
Lie Checker::lie(std::size_t primitive, const Feature& f, const I& t) const {
    return lie_of(f, part_of(primitive), span_of(primitive), motion_of(leg(), t).place, ball_->radius, t);
}
/// The feature of the primitive that the ball touches in the middle of the segment.
const Feature& Checker::held_on(std::size_t primitive) const {
    const I middle(leg().start + (leg().end - leg().start) / 2);
    return *std::ranges::min_element(features_[primitive], {}, [&](const Feature& f) {
        const Lie at = lie(primitive, f, middle);
        return at.facing ? size(at.gap.c[0]) : std::numeric_limits<double>::infinity();
    });
}

/// Slides, with friction against the slip, or rolls within Coulomb's cone; the surface only pushes.
void Checker::check_one_contact(const Feature& f) {
    const std::size_t primitive = leg().held[0];
    const double r = ball_->radius, scale = acceleration_;
    const I mu(friction_with(part_of(primitive)));
    const auto normal_force = [&](const I& t) {
        const JetVec force = force_at(t), n = lie(primitive, f, t).normal;
        return force.x * n.x + force.y * n.y;
    };
    const auto friction = [&](const I& t) {
        const JetVec force = force_at(t), n = lie(primitive, f, t).normal;
        return n.x * force.y - n.y * force.x;
    };
    const auto slip = [&](const I& t) {
        const Lie at = lie(primitive, f, t);
        const Motion m = motion_of(leg(), t);
        const JetVec v = velocity_of(m), u{v.x - at.velocity.x, v.y - at.velocity.y};
        return at.normal.x * u.y - at.normal.y * u.x - I(r) * m.spin;
    };
    stays_above("contact force is at least 0", scale, normal_force);
    stays_zero("spin changes by friction", scale,
               [&](const I& t) { return I(r / 2) * motion_of(leg(), t).spin.derivative() + friction(t); });
    const I begins = slip(I(leg().start)).c[0], ends = slip(I(leg().end)).c[0];
    if (std::max(size(begins), size(ends)) <= bound_ * speed_ && low(mu) > 0) {
        stays_zero("rolls without slip", speed_, slip);
        for (const int side : {1, -1})
            stays_above("friction within Coulomb's cone", scale,
                        [&](const I& t) { return mu * normal_force(t) - I(side) * friction(t); });
        return;
    }
    const I sign(low(begins) + low(ends) > 0 ? 1 : -1);
    if (low(mu) > 0) stays_above("slips one way", speed_, [&](const I& t) { return sign * slip(t); });
    stays_zero("friction against the slip", scale,
               [&](const I& t) { return friction(t) + sign * mu * normal_force(t); });
}

/// At rest between two surfaces: its weight is borne by them, with the friction that its spin makes.
void Checker::check_two_contacts(const std::vector<const Feature*>& on) {
    const Leg& now = leg();
    const double t = now.start, r = ball_->radius, sign = now.spin == 0 ? 0 : now.spin > 0 ? 1 : -1;
    if (on.size() != 2 || now.form != "rest") reject("held by two parts only at rest", t, 0);
    I x[2], y[2], rub[2];
    for (std::size_t i = 0; i < 2; ++i) {
        const Span* span = span_of(now.held[i]);
        if (span != nullptr && span->rate != 0) reject("rests on what stands still", t, std::abs(span->rate));
        rub[i] = sign * friction_with(part_of(now.held[i]));
        const JetVec n = lie(now.held[i], *on[i], I(t)).normal;
        x[i] = n.x.c[0] - rub[i] * n.y.c[0];
        y[i] = n.y.c[0] + rub[i] * n.x.c[0];
    }
    const I across = x[0] * y[1] - x[1] * y[0];
    const I first = (x[1] * run_.gravity[1] - y[1] * run_.gravity[0]) / across;
    const I second = (y[0] * run_.gravity[0] - x[0] * run_.gravity[1]) / across;
    require("both contact forces are at least 0", std::max(0.0, -std::min(low(first), low(second))),
            acceleration_, t);
    require_same("spin changes by friction", now.spin_rate * I(r), -2 * (rub[0] * first + rub[1] * second),
                 acceleration_, t);
    require("spin keeps its sense", std::max(0.0, -sign * (now.spin + (now.end - t) * now.spin_rate)) * r,
            speed_, now.end);
}

}  // namespace certificate
