#include "custom/response.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::custom {

namespace {

/// Coulomb's friction impulse along perp(normal), for a slip of `slip` m/s there. It stops the slip if it
/// can: for a tangential impulse the effective mass of a disc is 1/(1/m + r²/I) = m/3, with I = ½mr².
double friction_impulse(double friction, double normal_impulse, double slip, double mass) {
    const double limit = friction * normal_impulse;
    return std::clamp(-(mass / 3) * slip, -limit, limit);
}

/// Normal speed after an impact at `speed`.
double bounce(const Mixed& material, double speed) {
    return std::max(material.restitution * speed, material.kick);
}

}  // namespace

Impact respond(Ball& ball, const Touch& touch, Vec2 surface_velocity, const Mixed& material,
               const Surroundings& around) {
    const Vec2 normal = touch.normal, tangent = perp(normal);
    const Vec2 relative = ball.velocity - surface_velocity;
    const double closing = -dot(relative, normal);
    if (closing <= 0) return {};

    const double depth = -touch.separation;
    const double speed_squared = closing * closing + 2 * dot(around.gravity, normal) * depth;
    const double rounding = 1e-3 * closing;  // speed of a ball at rest, due to rounding
    const double speed = speed_squared > rounding * rounding ? std::sqrt(speed_squared) : 0;

    Impact impact{speed > around.rest_speed, normal, speed, 0};
    const double out = impact.happened ? bounce(material, speed) : 0;
    impact.impulse = ball.mass * (closing + out);
    ball.velocity += (closing + out) * normal;
    if (material.friction > 0) {
        const double slip = dot(relative, tangent) - ball.radius * ball.spin;
        const double friction = friction_impulse(material.friction, impact.impulse, slip, ball.mass);
        ball.velocity += friction / ball.mass * tangent;
        ball.spin -= ball.radius * friction / inertia(ball);
    }
    return impact;
}

Impact respond(Ball& a, Ball& b, const Mixed& material, const Surroundings& around) {
    const Vec2 between = a.position - b.position;
    const Vec2 relative = a.velocity - b.velocity;
    if (dot(between, relative) >= 0) return {};

    const Vec2 normal = unit(between), tangent = perp(normal);
    const double speed = -dot(relative, normal);
    // The speed that gravity gives a resting ball between two searches for contacts is no impact.
    const bool resting =
        speed <= around.rest_speed + std::abs(dot(around.gravity, normal)) * around.gravity_time;
    const double out = resting ? 0 : bounce(material, speed);
    const double inverse_mass = 1 / a.mass + 1 / b.mass;
    const Impact impact{!resting, normal, speed, (speed + out) / inverse_mass};

    Vec2 impulse = impact.impulse * normal;
    if (material.friction > 0) {
        const double slip = dot(relative, tangent) - a.radius * a.spin - b.radius * b.spin;
        const double friction = friction_impulse(material.friction, impact.impulse, slip, 1 / inverse_mass);
        impulse += friction * tangent;
        a.spin -= a.radius * friction / inertia(a);
        b.spin -= b.radius * friction / inertia(b);
    }
    a.velocity += impulse / a.mass;
    b.velocity -= impulse / b.mass;
    return impact;
}

void push_out(Ball& ball, const Touch& touch) {
    ball.position -= touch.separation * touch.normal;
}

void push_out(Ball& a, Ball& b, const Touch& touch) {
    const double share_a = b.mass / (a.mass + b.mass);
    a.position -= share_a * touch.separation * touch.normal;
    b.position += (1 - share_a) * touch.separation * touch.normal;
}

}  // namespace flipside::custom
