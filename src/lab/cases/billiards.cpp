// One ball between walls and past pins, without gravity.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

using std::numbers::pi;

Scene table() {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
    return scene;
}

/// A coordinate that runs to and fro between walls at 0 and 1 m.
double triangle_wave(double start, double way) {
    constexpr double width = 1 - 2 * radius;
    const double u = std::fmod(start - radius + way, 2 * width);
    return radius + (u < width ? u : 2 * width - u);
}

void note_hits(Experiment& experiment, const Trial& trial, std::uint64_t wanted) {
    const auto all = static_cast<double>(wanted);
    if (trial.impact_count() < wanted) experiment.cut_short();
    experiment.exact("hits", "", all, trial.impact_count() < wanted ? no_number : all, 0);
    experiment.always("balls lost", "", 0, static_cast<double>(trial.lost_count()));
}

void thin_wall_at(Experiment& experiment, double speed) {
    double worst = 0;
    int passed = 0;
    for (const double angle : {0.0, 0.4, 1.0}) {
        Scene scene = table();
        add_part(scene, segment({0, -50}, {0, 50}));
        add_ball(scene, {-1, 0}, speed * from_angle(angle), radius);
        Trial trial(experiment, scene);
        const double exact = (1 - radius) / (speed * math::cos(angle));
        const auto hit = trial.first_impact(2 * exact + 1);
        worst = hit ? std::max(worst, std::abs(hit->time / exact - 1)) : no_number;
        if (trial.ball(0).position.x > 0) ++passed;
    }
    const std::string of = ", " + text_of(speed / radius) + " r/s";
    experiment.exact("time of impact, relative error" + of, "", 0, worst, 1e-12);
    experiment.always("passed through the wall" + of, "", 0, passed);
}

}  // namespace

void box(Experiment& experiment) {
    const Vec2 start{0.3, 0.4}, velocity{23.7, 14.3};
    const auto wanted = experiment.size<std::uint64_t>(1'000'000, 5'000);
    Scene scene = table();
    add_part(scene, {shape::Polyline{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true}});
    add_ball(scene, start, velocity, radius);
    Trial trial(experiment, scene);
    while (trial.impact_count() < wanted && trial.may_step()) trial.step();
    const double t = trial.time();
    const Ball ball = trial.ball(0);
    const Vec2 exact{triangle_wave(start.x, velocity.x * t), triangle_wave(start.y, velocity.y * t)};
    note_hits(experiment, trial, wanted);
    experiment.exact("place after the last hit, error", "m", 0, length(ball.position - exact), 1e-9);
    experiment.exact("speed along x", "m/s", velocity.x, std::abs(ball.velocity.x), 1e-14);
    experiment.exact("speed along y", "m/s", velocity.y, std::abs(ball.velocity.y), 1e-14);
}

void circular_billiard(Experiment& experiment) {
    constexpr double alpha = 0.7, outer = 1, inner = outer - radius, speed = 40;
    const auto wanted = experiment.size<std::uint64_t>(1'000'000, 2'000);
    Scene scene = table();
    add_part(scene, {shape::Arc{{0, 0}, outer, 0, 2 * pi}});
    add_ball(scene, {inner, 0}, speed * from_angle(pi - alpha), radius);
    Trial trial(experiment, scene);
    double worst = 0;  // error of the angle over the number of hits
    std::uint64_t hits = 0;
    while (hits < wanted && trial.may_step()) {
        trial.step();
        for (const Event& impact : trial.impacts()) {
            ++hits;
            const double exact = std::remainder(pi - 2 * alpha, 2 * pi) * static_cast<double>(hits);
            const double error = std::abs(std::remainder(angle_of(impact.point) - exact, 2 * pi));
            worst = std::max(worst, error / static_cast<double>(hits));
        }
    }
    const Ball ball = trial.ball(0);
    note_hits(experiment, trial, wanted);
    // A hit may turn the way by ε, which after n hits has grown to n·ε per hit.
    const double rounding = 0x1p-53 * static_cast<double>(hits);
    experiment.exact("angle of a hit, worst error per hit", "rad", 0, worst, rounding);
    experiment.exact("radius of the caustic", "m", inner * math::sin(alpha),
                     std::abs(cross(ball.position, ball.velocity)) / length(ball.velocity), 1e-9);
    experiment.exact("speed", "m/s", speed, length(ball.velocity), speed * rounding);
}

void grazing(Experiment& experiment) {
    constexpr double pin = 0.4;
    for (const double delta : {1e-3, 1e-6, 1e-9, 1e-12, -1e-12, -1e-9}) {
        Scene scene = table();
        add_part(scene, {shape::Circle{{0, 0}, pin}});
        add_ball(scene, {-2, (pin + radius) * (1 - delta)}, {3, 0}, radius);
        Trial trial(experiment, scene);
        trial.run_to(2);
        const double exact = delta > 0 ? 2 * std::acos(1 - delta) : 0;
        // δ is rounded to ε of 1 in the ball's place.
        const double tolerance = delta > 0 ? exact * (1e-12 + 8 * 0x1p-53 / delta) : 0;
        experiment.exact("deflection, depth " + text_of(delta), "rad", exact,
                         angle_of(trial.ball(0).velocity), tolerance);
    }
}

void thin_wall(Experiment& experiment) {
    for (const double speed : {1.0, 1e2, 1e3, 1e5})
        experiment.attempt("wall at " + text_of(speed / radius) + " r/s",
                           [&] { thin_wall_at(experiment, speed); });
}

void deep_overlap(Experiment& experiment) {
    for (const double depth : {0.01, 0.1, 0.15}) {
        const std::string of = ", depth " + text_of(depth / radius) + " r";
        experiment.attempt("overlap" + of, [&] {
            Scene scene = table();
            add_part(scene, {shape::Polygon{{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}}}});
            add_ball(scene, {0.2, radius - depth}, {1, -2}, radius);
            Trial trial(experiment, scene);
            const double energy = trial.energy();
            double out = no_number;  // when it no longer overlaps
            trial.run_to(0.5, [&] {
                if (std::isnan(out) && trial.ball(0).position.y >= radius) out = trial.time();
            });
            experiment.exact("energy gained" + of, "J", 0, trial.energy() - energy, 1e-12);
            const double overlap = std::max(0.0, 1 - trial.ball(0).position.y / radius);
            experiment.always("overlap at the end" + of, "r", 0, overlap, 0.05);
            experiment.note("time until it is free, in whole steps" + of, "s", out);
        });
    }
}

}  // namespace flipside::lab
