// Balls that roll, begin to slip because friction is too weak, and roll again: the engines that find events
// at their times.

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

constexpr double standard_gravity = 9.81, ball_radius = 0.1;  // m/s², m

std::vector<std::unique_ptr<World>> exact_worlds(const Scene& scene) {
    std::vector<std::unique_ptr<World>> worlds;
    for (const char* name : {"custom", "reference"}) {
        const Engine& engine = lab::engine_named(name);
        worlds.push_back(engine.make(std::make_shared<const Scene>(scene), Settings(engine.settings)));
    }
    return worlds;
}

void run_for(World& world, double seconds, double dt) {
    for (int step = 0; step < std::lround(seconds / dt); ++step) world.step(dt);
}

// On a floor, a pull along it is at first too strong for rolling; then drag has taken enough of it.
TEST(Slip, EndsWhenDragHasSlowedTheBall) {
    const double pull = 12, drag = 2, friction = 0.3, rubbed = pull - friction * standard_gravity;
    Scene scene = empty_scene({pull, -standard_gravity});
    scene.damping = drag;
    scene.materials[0].friction = friction;
    add_ball(scene, {0, ball_radius});
    add_part(scene, segment({-1, 0}, {50, 0}), {"", 0, friction, 0});
    // It slips at (v, x) with v' = rubbed − drag·v, until v is the speed of the rim, 2µgt.
    const auto speed = [&](double t) { return rubbed / drag * (1 - std::exp(-drag * t)); };
    double before = 0.1, after = 1;
    for (int halving = 0; halving < 60; ++halving) {
        const double t = (before + after) / 2;
        (speed(t) > 2 * friction * standard_gravity * t ? before : after) = t;
    }
    const double slipped = rubbed / drag * before - speed(before) / drag;
    // Then it rolls with v' = ⅔(pull − drag·v).
    const double rolled = 1 - before, rate = 2 * drag / 3, faster = speed(before) - pull / drag;
    const double left = std::exp(-rate * rolled);
    for (const auto& world : exact_worlds(scene))
        for (const double dt : {1.0 / 60, 1.0 / 1000}) {
            const auto start = world->save();
            run_for(*world, 1, dt);
            const Ball& ball = world->balls()[0];
            EXPECT_NEAR(ball.velocity.x, pull / drag + faster * left, 1e-11);
            EXPECT_NEAR(ball.spin, -ball.velocity.x / ball_radius, 1e-10);
            EXPECT_NEAR(ball.position.x, slipped + pull / drag * rolled + faster * (1 - left) / rate, 1e-11);
            world->restore(start);
        }
}

// A ball rolls up a hill of 1 m. Where it is steep the ball slips, nearer to the top it rolls again.
TEST(Slip, EndsNearTheTopOfAHill) {
    const double friction = 0.2, slope = 24.5 * std::numbers::pi / 180, speed = 1.6;
    // The hill is turned so that the ball starts on the vertical line through its centre, just before the
    // place at 23.9 degrees from which on friction is strong enough.
    Scene scene = empty_scene(standard_gravity * Vec2{std::sin(slope), -std::cos(slope)});
    scene.materials[0].friction = friction;
    add_ball(scene, {0, 1 + ball_radius}, {-speed, 0}).spin = speed / ball_radius;
    add_part(scene, {shape::Circle{{0, 0}, 1}}, {"", 0, friction, 0});
    const auto slip = [](const Ball& ball) {
        return dot(ball.velocity, perp(unit(ball.position))) - ball_radius * ball.spin;
    };
    std::vector<Vec2> ends;
    for (const auto& world : exact_worlds(scene)) {
        run_for(*world, 0.005, 0.001);
        EXPECT_GT(std::abs(slip(world->balls()[0])), 1e-4);
        run_for(*world, 0.025, 0.001);
        EXPECT_NEAR(slip(world->balls()[0]), 0, 1e-14);
        EXPECT_NEAR(length(world->balls()[0].position), 1 + ball_radius, 1e-14);
        ends.push_back(world->balls()[0].position);
    }
    EXPECT_LT(length(ends[0] - ends[1]), 1e-14);
}

/// A ball on the outside (side 1) or inside (−1) of a circle of 1 m about 0, by the equations of motion, in
/// steps of the Runge-Kutta method.
struct OnCircle {
    double side = 1, friction = 0, drag = 0;
    Vec2 gravity;
    double angle = 0, speed = 0, spin_speed = 0;  ///< rad; m/s of the centre, and of the rim

    struct Rates {
        double angle, speed, spin_speed;
    };
    enum class Mode { slips_forwards, slips_backwards, rolls };

    [[nodiscard]] double length() const { return 1 + side * ball_radius; }
    [[nodiscard]] Vec2 out() const { return from_angle(angle); }
    [[nodiscard]] double slip() const { return side * speed - spin_speed; }
    [[nodiscard]] double force() const { return -side * (speed * speed / length() + dot(gravity, out())); }
    [[nodiscard]] double tangential() const { return side * (dot(gravity, perp(out())) - drag * speed); }
    [[nodiscard]] Rates rates(Mode mode) const {
        const double rub = mode == Mode::rolls            ? -tangential() / 3
                           : mode == Mode::slips_forwards ? -friction * force()
                                                          : friction * force();
        return {speed / length(), side * (tangential() + rub), -2 * rub};
    }
    [[nodiscard]] OnCircle moved(const Rates& r, double t) const {
        OnCircle later = *this;
        later.angle += r.angle * t, later.speed += r.speed * t, later.spin_speed += r.spin_speed * t;
        return later;
    }
    [[nodiscard]] OnCircle after(Mode mode, double t) const {
        const Rates a = rates(mode), b = moved(a, t / 2).rates(mode), c = moved(b, t / 2).rates(mode),
                    d = moved(c, t).rates(mode);
        return moved({(a.angle + 2 * b.angle + 2 * c.angle + d.angle) / 6,
                      (a.speed + 2 * b.speed + 2 * c.speed + d.speed) / 6,
                      (a.spin_speed + 2 * b.spin_speed + 2 * c.spin_speed + d.spin_speed) / 6},
                     t);
    }
    [[nodiscard]] Mode mode() const {
        if (std::abs(slip()) < 1e-12 && std::abs(tangential()) < 3 * friction * force()) return Mode::rolls;
        const bool forwards = std::abs(slip()) < 1e-12 ? tangential() > 0 : slip() > 0;
        return forwards ? Mode::slips_forwards : Mode::slips_backwards;
    }
    /// Whether the ball, which was in this mode before, has left it.
    [[nodiscard]] bool has_left(Mode before) const {
        if (before == Mode::rolls) return std::abs(tangential()) > 3 * friction * force();
        return before == Mode::slips_forwards ? slip() < 0 : slip() > 0;
    }
    /// Moves by t, in two parts where it begins or ceases to roll. Returns whether it did.
    bool move(double t) {
        const Mode now = mode();
        const bool starts = now != Mode::rolls && std::abs(slip()) < 1e-12;
        if (starts || !after(now, t).has_left(now)) {
            *this = after(now, t);
            return false;
        }
        double before = 0, end = t;
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = (before + end) / 2;
            (after(now, middle).has_left(now) ? end : before) = middle;
        }
        *this = after(now, end);
        spin_speed = side * speed;
        *this = after(mode(), t - end);
        return true;
    }
};

// Balls with any velocity and spin on hills and in bowls, under any gravity.
TEST(Slip, BeginsAndEndsAsTheEquationsOfMotionSay) {
    std::mt19937 random(7);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 0x1p32;
    };
    int ends = 0, begins = 0, compared = 0;
    for (int k = 0; k < 400; ++k) {
        OnCircle on;
        on.side = k % 2 == 0 ? 1 : -1;
        on.friction = number(0.02, 0.6);
        on.drag = k % 3 == 0 ? number(0, 3) : 0;
        on.gravity = -standard_gravity * from_angle(number(-0.9, 0.9)) * on.side;
        on.speed = number(-2, 2);
        // Every other ball begins without slip.
        on.spin_speed = k % 4 < 2 ? on.side * on.speed : number(-2, 2);
        Scene scene = empty_scene(on.gravity);
        scene.damping = on.drag;
        scene.materials[0].friction = on.friction;
        add_ball(scene, {on.length(), 0}, {0, on.speed}).spin = on.spin_speed / ball_radius;
        const Shape circle = on.side > 0 ? Shape{shape::Circle{{0, 0}, 1}}
                                         : Shape{shape::Arc{{0, 0}, 1, 0, 2 * std::numbers::pi}};
        add_part(scene, circle, {"", 0, on.friction, 0});
        const auto worlds = exact_worlds(scene);
        for (int step = 0; step < 30; ++step) {
            for (int part = 0; part < 200 && on.force() > 0.1; ++part) {
                const bool rolled = on.mode() == OnCircle::Mode::rolls;
                (rolled ? begins : ends) += on.move(5e-5);
            }
            if (!(on.force() > 0.1)) break;  // it soon flies off
            for (const auto& world : worlds) {
                world->step(0.01);
                const Ball& ball = world->balls()[0];
                ASSERT_LT(length(ball.position - on.length() * on.out()), 1e-9)
                    << "ball " << k << ", " << world->time() << " s";
                ASSERT_NEAR(ball.spin * ball_radius, on.spin_speed, 1e-8) << "ball " << k;
            }
            ++compared;
        }
    }
    std::printf("%d steps compared; slip ended %d times and began %d times\n", compared, ends, begins);
    EXPECT_GT(ends, 50);
    EXPECT_GT(begins, 20);
}

}  // namespace
}  // namespace flipside
