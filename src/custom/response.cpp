#include "custom/response.hpp"

#include <algorithm>

#include "custom/geometry/sweep.hpp"

namespace flipside::custom {

namespace {

/// Coulomb's tangential impulse along perp(normal), for a slip of `slip` m/s there that an impulse of
/// `sticking_mass`·slip would stop.
double friction_impulse(double friction, double normal_impulse, double slip, double sticking_mass) {
    const double limit = friction * normal_impulse;
    return std::clamp(-sticking_mass * slip, -limit, limit);
}

/// Outgoing normal speed of an impact at `speed`.
double bounce(const Mixed& material, double speed) {
    return std::max(material.restitution * speed, material.kick);
}

/// Mass against a tangential impulse at the rim of a disc: 1/(1/m + r²/I) with I = ½mr².
double rim_mass(double mass) {
    return mass / 3;
}

/// Time since two discs that now overlap touched, when they flew straight relative to each other:
/// |x − v·t| = reach. Needs |x| < reach and x·v < 0.
double since_touch(Vec2 x, Vec2 v, double reach) {
    const double beyond = reach * reach - length_squared(x);
    const double approach = dot(x, v);
    return beyond / (std::sqrt(approach * approach + length_squared(v) * beyond) - approach);
}

}  // namespace

Impact respond(Ball& ball, const Touch& touch, Vec2 surface_velocity, const Mixed& material,
               const Surroundings& around) {
    const Vec2 normal = touch.normal, tangent = perp(normal);
    const Vec2 relative = ball.velocity - surface_velocity;
    const double closing = -dot(relative, normal);
    if (closing <= 0) return {};

    // Back to the surface: energy is conserved on the way, and so is angular momentum about the centre
    // of curvature, which turns tangential into normal speed.
    const double depth = -touch.separation;
    const double along = dot(relative, tangent);
    const double ratio = 1 / std::max(0.5, 1 + touch.curvature * depth);
    const double speed_squared = closing * closing + 2 * dot(around.gravity, normal) * depth +
                                 along * along * (1 - ratio) * (1 + ratio);
    // What is left of a resting touch is rounding, and the curvature's terms of third order.
    const double noise = 1e-3 * closing;
    const double speed = speed_squared > noise * noise ? std::sqrt(speed_squared) : 0;

    Impact impact{speed > around.rest_speed, normal, speed, 0, 0};
    double& ago = impact.ago;
    Vec2 change;
    if (impact.happened) {
        const double out = bounce(material, speed);
        ago = 2 * depth / (closing + speed);
        ago = std::clamp(ago, 0.0, around.flown);
        change = (ago > 0 ? speed + out : closing + out) * normal;
        impact.impulse = ball.mass * (speed + out);
    } else {
        change = closing * normal + (along * (ratio - 1)) * tangent;
        impact.impulse = ball.mass * closing;
    }
    if (material.friction > 0) {
        const double slip = along - ball.radius * ball.spin;
        const double grip = friction_impulse(material.friction, impact.impulse, slip, rim_mass(ball.mass));
        change += grip / ball.mass * tangent;
        const double turn = -ball.radius * grip / inertia(ball);
        ball.spin += turn;
        ball.angle += turn * ago;
    }
    ball.velocity += change;
    ball.position += ago * change;
    return impact;
}

Impact respond(Ball& a, Ball& b, bool held_b, const Mixed& material, const Surroundings& around) {
    const Vec2 between = a.position - b.position;
    const Vec2 relative = a.velocity - b.velocity;
    const double approach = dot(between, relative);
    if (approach >= 0) return {};

    const double reach = a.radius + b.radius;
    const double distance = length(between);
    double ago = distance < reach ? std::min(since_touch(between, relative, reach), around.flown) : 0;
    const Vec2 normal = unit(between - ago * relative), tangent = perp(normal);
    const double speed = -dot(relative, normal);

    // Gravity drives a ball into the one it rests on during the flight: that much is no impact.
    const bool resting = speed <= around.rest_speed + std::abs(dot(around.gravity, normal)) * around.driven;
    const double out = resting ? 0 : bounce(material, speed);
    const double per_mass_b = held_b ? 0 : 1 / b.mass;
    const double per_mass = 1 / a.mass + per_mass_b;
    Impact impact{!resting, normal, speed, (speed + out) / per_mass, ago};
    if (resting) impact.ago = ago = 0;

    Vec2 impulse = impact.impulse * normal;
    if (material.friction > 0) {
        const double slip = dot(relative, tangent) - a.radius * a.spin - b.radius * b.spin;
        const double grip = friction_impulse(material.friction, impact.impulse, slip, rim_mass(1 / per_mass));
        impulse += grip * tangent;
        a.spin -= a.radius * grip / inertia(a);
        if (!held_b) b.spin -= b.radius * grip / inertia(b);
    }
    const Vec2 change_a = impulse / a.mass, change_b = -per_mass_b * impulse;
    a.velocity += change_a;
    a.position += ago * change_a;
    b.velocity += change_b;
    b.position += ago * change_b;
    return impact;
}

double passed_through(const Ball& a, const Ball& b, double flown) {
    // The later root of |x − v·t| = reach, counted backwards: when they came together.
    const Vec2 x = a.position - b.position, v = a.velocity - b.velocity;
    const double reach = a.radius + b.radius, parting = dot(x, v), speed_squared = length_squared(v);
    const double inside = parting * parting - speed_squared * (length_squared(x) - reach * reach);
    if (parting <= 0 || inside <= 0) return never;
    const double ago = (parting + std::sqrt(inside)) / speed_squared;
    // Those that touched when the flight began were answered then.
    constexpr double same_moment = 1e-6;
    return ago < (1 - same_moment) * flown ? ago : never;
}

void push_out(Ball& ball, const Touch& touch) {
    if (touch.separation < 0) ball.position -= touch.separation * touch.normal;
}

void push_out(Ball& a, Ball& b, bool held_b) {
    const Touch apart = touch(a.position, a.radius, b.position, b.radius);
    if (apart.separation >= 0) return;
    const double share_a = held_b ? 1 : b.mass / (a.mass + b.mass);
    a.position -= share_a * apart.separation * apart.normal;
    b.position += (1 - share_a) * apart.separation * apart.normal;
}

}  // namespace flipside::custom
