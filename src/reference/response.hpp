#pragma once
/// What an impact does: restitution along the normal, at least the kick, Coulomb friction across it, capped
/// at what stops the slip.

#include <algorithm>

#include "reference/resting_contact.hpp"
#include "world/scene.hpp"

namespace flipside::reference {

template <class R>
struct Impact {
    bool happened = false;  ///< faster than the rest speed
    R speed{}, impulse{};   ///< m/s and N·s, along the normal
};

/// A disc resists a push at its rim with a third of its mass.
template <class R>
R friction_impulse(const Mixed& material, const R& impulse, const R& slip, const R& mass) {
    const R most = R(material.friction) * impulse;
    return std::clamp(R(-slip * mass / 3), R(-most), most);
}

template <class R>
R outgoing(const Mixed& material, const R& speed) {
    return std::max(R(material.restitution) * speed, R(material.kick));
}

/// A ball against a surface of infinite mass that moves with `surface` where they touch.
template <class R>
Impact<R> respond(Body<R>& ball, const R& mass, const V<R>& normal, const V<R>& surface,
                  const Mixed& material, double rest_speed) {
    const V<R> relative = ball.velocity - surface, tangent = perp(normal);
    Impact<R> impact;
    impact.speed = -dot(relative, normal);
    impact.happened = impact.speed > rest_speed;
    const R gained = impact.speed + (impact.happened ? outgoing(material, impact.speed) : R(0));
    impact.impulse = mass * gained;
    const R slip = dot(relative, tangent) - ball.radius * ball.spin;
    const R rub = friction_impulse(material, impact.impulse, slip, mass);
    ball.velocity += gained * normal + (rub / mass) * tangent;
    ball.spin -= 2 * rub / (mass * ball.radius);
    return impact;
}

/// Two balls; the normal points from b to a.
template <class R>
Impact<R> respond(Body<R>& a, const R& mass_a, Body<R>& b, const R& mass_b, const V<R>& normal,
                  const Mixed& material, double rest_speed) {
    const V<R> relative = a.velocity - b.velocity, tangent = perp(normal);
    const R mass = mass_a * mass_b / (mass_a + mass_b);
    Impact<R> impact;
    impact.speed = -dot(relative, normal);
    impact.happened = impact.speed > rest_speed;
    impact.impulse = mass * (impact.speed + (impact.happened ? outgoing(material, impact.speed) : R(0)));
    const R slip = dot(relative, tangent) - a.radius * a.spin - b.radius * b.spin;
    const R rub = friction_impulse(material, impact.impulse, slip, mass);
    const V<R> push = impact.impulse * normal + rub * tangent;
    a.velocity += push / mass_a;
    b.velocity -= push / mass_b;
    a.spin -= 2 * rub / (mass_a * a.radius);
    b.spin -= 2 * rub / (mass_b * b.radius);
    return impact;
}

}  // namespace flipside::reference
