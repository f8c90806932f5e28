// What an impact does, on every engine, against the formulas of the physical model: a ball thrown at a
// straight wall, and at another ball, with random masses, radii, spins, restitution and friction. Normal: (1
// + e) times the approach, by the effective mass. Along the surface: what stops the slip, but no more than µ
// times the normal impulse (Coulomb); of a disc a third of the mass resists there.
//
// The continuous solver and the reference are exact to rounding. The others have bounds that were measured
// and doubled: the simple solver, exact at a wall, finds two balls when they overlap already, where the
// normal is another; so does Box2D without its sub-step of continuous collision, whose friction moreover acts
// in a step in which restitution has parted the two.

#include <random>

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/engines/every_solver.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

constexpr double step = 1.0 / 240;
constexpr int steps_after = 4;  // so that a contact that lasts for longer than the impact shows
constexpr int throws = flipside::test::in_small ? 100 : 1000;

double among(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// What an engine may be off by.
struct Bound {
    double velocity;  ///< of the rim or the centre, in parts of the approach
    double impulse;   ///< along the normal, relative
};

Bound bound_of(const Engine& engine, const Settings& settings, bool between_balls) {
    if (engine.name == "box2d") return between_balls ? Bound{0.15, 0.1} : Bound{0.1, 1e-5};
    if (engine.name == "custom" && settings.text("solver") == "simple" && between_balls) return {0.05, 0.035};
    return {1e-12, 1e-12};
}

struct After {
    Vec2 velocity, other_velocity;
    double spin = 0, other_spin = 0, impulse = 0;
};

/// By the physical model; `normal` points from the other to the ball, and `other` is null for a still wall.
After after_by_model(const Ball& ball, const Ball* other, Vec2 normal, Mixed mixed) {
    const Vec2 tangent = perp(normal);
    const double per_mass = 1 / ball.mass + (other ? 1 / other->mass : 0);
    const Vec2 relative = ball.velocity - (other ? other->velocity : Vec2{});
    const double slip =
        dot(relative, tangent) - ball.radius * ball.spin - (other ? other->radius * other->spin : 0);
    After after;
    after.impulse = -(1 + mixed.restitution) * dot(relative, normal) / per_mass;
    const double most = mixed.friction * after.impulse;
    const double along = std::clamp(-slip / (3 * per_mass), -most, most);
    after.velocity = ball.velocity + (after.impulse * normal + along * tangent) / ball.mass;
    after.spin = ball.spin - along * ball.radius / inertia(ball);
    if (other == nullptr) return after;
    after.other_velocity = other->velocity - (after.impulse * normal + along * tangent) / other->mass;
    after.other_spin = other->spin - along * other->radius / inertia(*other);
    return after;
}

/// Runs until some steps after the first impact.
After after_run(const std::shared_ptr<const Scene>& scene, const Engine& engine, const Settings& settings) {
    const auto world = engine.make(scene, settings);
    After found;
    for (int left = 400, after = -1; left > 0 && after != 0; --left) {
        world->step(step);
        for (const Event& event : world->events())
            if (event.kind == EventKind::impact && after < 0)
                found.impulse = event.impulse, after = steps_after;
        if (after > 0) --after;
    }
    const std::span<const Ball> balls = world->balls();
    found.velocity = balls[0].velocity;
    found.spin = balls[0].spin;
    if (balls.size() > 1) found.other_velocity = balls[1].velocity, found.other_spin = balls[1].spin;
    return found;
}

/// The largest error of a velocity.
double error_of(const After& found, const After& truth, const Scene& scene) {
    double error = std::max(length(found.velocity - truth.velocity),
                            scene.balls[0].radius * std::abs(found.spin - truth.spin));
    if (scene.balls.size() > 1)
        error = std::max({error, length(found.other_velocity - truth.other_velocity),
                          scene.balls[1].radius * std::abs(found.other_spin - truth.other_spin)});
    return error;
}

Material random_material(std::mt19937_64& random) {
    return {"", among(random, 0.2, 1), among(random, 0, 1) < 0.3 ? 0 : among(random, 0.05, 0.6), 0};
}

Ball& random_ball(std::mt19937_64& random, Scene& scene, Vec2 position, Vec2 velocity) {
    Ball& ball = add_ball(scene, position, velocity, among(random, 0.05, 0.15), among(random, 0.5, 4));
    ball.spin = among(random, -20, 20);
    return ball;
}

struct Meeting {
    Scene scene;
    After truth;
    double approach = 0;  ///< m/s
};

Meeting at_wall(std::mt19937_64& random) {
    Meeting thrown{empty_scene(), {}};
    Scene& scene = thrown.scene;
    scene.rest_speed = 0;
    const Vec2 normal = from_angle(among(random, 0, 6.2)), tangent = perp(normal);
    scene.materials[0] = random_material(random);
    add_part(scene, segment(-3 * tangent, 3 * tangent), random_material(random));
    const Vec2 velocity = -among(random, 1.5, 5) * normal + among(random, -3, 3) * tangent;
    Ball& ball = random_ball(random, scene, {}, velocity);
    ball.position = (ball.radius + 0.2) * normal;
    thrown.truth = after_by_model(ball, nullptr, normal, mix(scene.materials[0], scene.materials[1]));
    thrown.approach = -dot(velocity, normal);
    return thrown;
}

Meeting at_ball(std::mt19937_64& random) {
    Meeting thrown{empty_scene(), {}};
    Scene& scene = thrown.scene;
    scene.rest_speed = 0;
    scene.materials[0] = random_material(random);
    const Vec2 normal = from_angle(among(random, 0, 6.2)), tangent = perp(normal);
    const Vec2 relative = -among(random, 1.5, 5) * normal + among(random, -2, 2) * tangent;
    const Vec2 drift = {among(random, -1, 1), among(random, -1, 1)};
    scene.balls.reserve(2);
    Ball& ball = random_ball(random, scene, {}, relative + drift);
    Ball& other = random_ball(random, scene, {}, drift);
    // They meet a tenth of a second from now, with this normal.
    ball.position = other.position + (ball.radius + other.radius) * normal - 0.1 * relative;
    thrown.truth = after_by_model(ball, &other, normal, mix(scene.materials[0], scene.materials[0]));
    thrown.approach = -dot(relative, normal);
    return thrown;
}

class Impulses : public testing::TestWithParam<Meeting (*)(std::mt19937_64&)> {};

TEST_P(Impulses, AreThoseOfTheModel) {
    for (const auto& [engine, settings] : lab::every_solver()) {
        std::mt19937_64 random(20261124);
        double worst = 0, worst_impulse = 0;
        for (int i = 0; i < throws; ++i) {
            const Meeting thrown = GetParam()(random);
            const After found = after_run(std::make_shared<const Scene>(thrown.scene), *engine, settings);
            ASSERT_GT(found.impulse, 0) << engine->name << ' ' << i << ": must meet";
            worst = std::max(worst, error_of(found, thrown.truth, thrown.scene) / thrown.approach);
            worst_impulse = std::max(worst_impulse, std::abs(found.impulse / thrown.truth.impulse - 1));
        }
        const Bound bound = bound_of(*engine, settings, GetParam()(random).scene.balls.size() > 1);
        EXPECT_LE(worst, bound.velocity) << engine->name;
        EXPECT_LE(worst_impulse, bound.impulse) << engine->name;
    }
}

INSTANTIATE_TEST_SUITE_P(Throws, Impulses, testing::Values(at_wall, at_ball));

}  // namespace
}  // namespace flipside
