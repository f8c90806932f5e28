// Balls that slide, roll, swing and come to rest.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

using std::numbers::pi;

/// Arithmetic-geometric mean (Gauss 1799).
double agm(double a, double b) {
    for (int i = 0; i < 8; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

/// When ball 0 passed x = 0 in the step of `dt` that began at `before`: Newton's method, each try with a
/// world of its own from there.
double passing_time(Experiment& experiment, const Scene& scene, const State& before, double guess) {
    double t = guess;
    for (int i = 0; i < 4; ++i) {
        Trial probe(experiment, scene, before);
        probe.step(t);
        t -= probe.ball(0).position.x / probe.ball(0).velocity.x;
    }
    return before.clock.time + t;
}

/// A ball that lies on a slope falling to the right at `alpha`, and what friction does to it in a second.
void slope_with(Experiment& experiment, double alpha, double friction, double acceleration,
                const std::string& name) {
    const Vec2 down = from_angle(-alpha), up = perp(down);
    Scene scene = empty_scene({0, -g});
    scene.materials[0].friction = friction;
    add_part(scene, segment(-1 * down, 20 * down), {"", 0.5, friction, 0});
    add_ball(scene, radius * up, {}, radius);
    Trial trial(experiment, scene);
    trial.run_to(1);
    const Ball ball = trial.ball(0);
    experiment.exact("way down in 1 s, " + name, "m", acceleration / 2, dot(ball.position, down), 1e-9);
    experiment.exact("speed after 1 s, " + name, "m/s", acceleration, dot(ball.velocity, down), 1e-9);
    // What turns the disc is the friction that the motion down lacks: I·ω' = (g·sin α − a)·m·r.
    experiment.exact("spin after 1 s, " + name, "rad/s", -2 * (g * math::sin(alpha) - acceleration) / radius,
                     ball.spin, 1e-8);
}

void slide_to_roll(Experiment& experiment) {
    constexpr double start = 3, friction = 0.2;
    Scene scene = empty_scene({0, -g});
    scene.materials[0].friction = friction;
    add_part(scene, segment({-1, 0}, {20, 0}), {"", 0.5, friction, 0});
    add_ball(scene, {0, radius}, {start, 0}, radius);
    Trial trial(experiment, scene);
    trial.run_to(1);
    const double rolls = start / (3 * friction * g);
    const double way = start * rolls - friction * g * rolls * rolls / 2 + 2 * start / 3 * (1 - rolls);
    experiment.exact("speed once it rolls, from 3 m/s", "m/s", 2 * start / 3, trial.ball(0).velocity.x, 1e-9);
    experiment.exact("way in 1 s, from 3 m/s", "m", way, trial.ball(0).position.x, 1e-9);
    experiment.exact("spin once it rolls, from 3 m/s", "rad/s", -2 * start / 3 / radius, trial.ball(0).spin,
                     1e-8);
}

void collinear_with(Experiment& experiment, double angle, double weight) {
    constexpr int primitives = 10'000;
    constexpr double speed = 5;
    const Vec2 along = from_angle(angle);
    Scene scene = empty_scene(weight * -perp(along));
    scene.bounds = {{-1000, -1000}, {1000, 1000}};
    shape::Polyline floor;
    for (int i = 0; i <= primitives; ++i) floor.points.push_back(0.01 * i * along);
    add_part(scene, {floor}, {"", 0.5, 0, 0});
    add_ball(scene, 0.05 * along + radius * perp(along), speed * along, radius);
    Trial trial(experiment, scene);
    const double seconds = experiment.size(19.0, 4.0);
    trial.run_to(seconds);
    const Ball ball = trial.ball(0);
    const std::string of =
        std::string(angle == 0 ? ", flat" : ", turned") + (weight == 0 ? ", no weight" : "");
    experiment.exact("impacts" + of, "", 0, static_cast<double>(trial.impact_count()), 0);
    // The corners of a turned floor are rounded: its primitives slope by up to 1e-14.
    experiment.exact("speed along" + of, "m/s", speed, dot(ball.velocity, along), 1e-11);
    experiment.exact("way along" + of, "m", 0.05 + speed * seconds, dot(ball.position, along), 1e-9);
    experiment.exact("height" + of, "m", radius, dot(ball.position, perp(along)), 1e-10);
}

void pile_of(Experiment& experiment, const Scene& scene, const std::string& name) {
    constexpr double seconds = 15;
    Trial trial(experiment, scene);
    trial.run_to(seconds - 1);
    const State before = trial.world().save();
    trial.run_to(seconds);
    double deepest = 0, moved = 0;
    for (const Contact& contact : trial.world().contacts())
        deepest = std::max(deepest, -contact.separation / radius);
    for (const Ball& ball : before.balls)
        moved = std::max(moved, length(trial.ball(ball.number).position - ball.position) / radius);
    const auto balls = static_cast<double>(scene.balls.size());
    experiment.always("balls lost, " + name, "", 0, static_cast<double>(trial.lost_count()));
    experiment.exact("deepest overlap, " + name, "r", 0, deepest, 0.01);
    experiment.exact("largest way in the last second, " + name, "r", 0, moved, 1e-3);
    experiment.exact("asleep, " + name, "", balls, static_cast<double>(trial.world().statistics().asleep), 0);
}

}  // namespace

void bowl(Experiment& experiment) {
    constexpr double start = pi / 3, arm = 1;
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_part(scene, {shape::Arc{{0, 0}, arm + radius, pi, 2 * pi}});
    add_ball(scene, arm * from_angle(-pi / 2 + start), {}, radius);
    const double period = 2 * pi * std::sqrt(arm / g) / agm(1, math::cos(start / 2));
    // The tenth time that it swings through the lowest point to the left ends 9 periods and a quarter.
    constexpr int passes = 10;
    Trial trial(experiment, scene);
    State before = trial.world().save();
    int passed = 0;
    double guess = 0;
    const bool swung = trial.run_until(
        [&] {
            const double from = before.balls[0].position.x, to = trial.ball(0).position.x;
            guess = experiment.dt() * from / (from - to);
            if (from > 0 && to <= 0 && ++passed == passes) return true;
            before = trial.world().save();
            return false;
        },
        2 * passes * period);
    experiment.exact("period from 60 degrees", "s", period,
                     swung ? passing_time(experiment, scene, before, guess) / (passes - 0.75) : no_number,
                     1e-11);
    experiment.exact("impacts on the way", "", 0, static_cast<double>(trial.impact_count()), 0);
}

void leaving_a_circle(Experiment& experiment) {
    constexpr double start = 0.01;
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_part(scene, {shape::Circle{{0, 0}, 1 - radius}});
    add_ball(scene, Vec2{math::sin(start), math::cos(start)}, {}, radius);
    Trial trial(experiment, scene);
    const bool left = trial.run_until([&] { return trial.ball(0).position.y <= 0; }, 20);
    // In flight: back to where it left the circle of radius 1 m.
    const Ball ball = trial.ball(0);
    const double cosine = 2.0 / 3 * math::cos(start), sine = std::sqrt(1 - cosine * cosine);
    const double speed = std::sqrt(g * cosine), vx = speed * cosine;
    const double t = (ball.position.x - sine) / vx;
    experiment.exact("cosine of the angle where it leaves", "", cosine,
                     left ? std::cbrt(ball.velocity.x * ball.velocity.x / g) : no_number, 1e-9);
    experiment.exact("height over the exact parabola", "m", 0,
                     left ? ball.position.y - (cosine - speed * sine * t - g * t * t / 2) : no_number, 1e-9);
}

void incline(Experiment& experiment) {
    const double alpha = pi / 6, sine = math::sin(alpha), cosine = math::cos(alpha);
    experiment.attempt("smooth slope", [&] { slope_with(experiment, alpha, 0, g * sine, "smooth"); });
    experiment.attempt("rolling", [&] { slope_with(experiment, alpha, 0.5, g * sine * 2 / 3, "rolling"); });
    experiment.attempt("slipping",
                       [&] { slope_with(experiment, alpha, 0.1, g * (sine - 0.1 * cosine), "slipping"); });
    experiment.attempt("slide to roll", [&] { slide_to_roll(experiment); });
}

void collinear_segments(Experiment& experiment) {
    for (const double angle : {0.0, 0.3})
        for (const double weight : {g, 0.0}) collinear_with(experiment, angle, weight);
}

void pile(Experiment& experiment) {
    Scene column = empty_scene({0, -g});
    column.materials[0].restitution = 0.5;
    add_part(column, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
    for (int i = 0; i < 10; ++i) add_ball(column, {0, radius + 0.21 * i}, {}, radius);
    experiment.attempt("column", [&] { pile_of(experiment, column, "column of 10"); });

    const int count = experiment.size(50, 20);
    Scene pit = empty_scene({0, -g});
    pit.materials[0].restitution = 0.5;
    add_part(pit, {shape::Polyline{{{-4, 4}, {0, 0}, {4, 4}}, false}}, {"", 0.5, 0, 0});
    for (int i = 0; i < count; ++i) {
        const int row = i / 9;
        add_ball(pit, {-0.9 + 0.21 * (i % 9) + 0.003 * row, 1.2 + 0.25 * row}, {}, radius);
    }
    experiment.attempt("V", [&] { pile_of(experiment, pit, "V of " + text_of(count)); });
}

}  // namespace flipside::lab
