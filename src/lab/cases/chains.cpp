// Balls in a row.

#include <algorithm>
#include <cmath>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

/// Elastic, too wide to leave.
Scene open_line(Vec2 gravity = {}) {
    Scene scene = empty_scene(gravity);
    scene.rest_speed = 0;
    scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
    return scene;
}

struct Free {
    double x, v;
};

/// A point that bounces elastically between 0 and `width`.
double unfolded(Free point, double time, double width) {
    const double u = std::fmod(std::fmod(point.x + point.v * time, 2 * width) + 2 * width, 2 * width);
    return u < width ? u : 2 * width - u;
}

using Coordinate = double Vec2::*;

/// Largest distance of a ball from sorted free points, each shifted by the balls before it.
double worst_of_row(const Trial& trial, std::vector<double> free, double r, Coordinate coordinate) {
    std::ranges::sort(free);
    double worst = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
        const Ball ball = trial.ball(static_cast<BallNumber>(i));
        const double exact = free[i] + (2 * static_cast<double>(i) + 1) * r;
        const double error = std::abs(ball.position.*coordinate - exact);
        worst = std::isnan(error) ? error : std::max(worst, error);
    }
    return worst;
}

void cradle_with(Experiment& experiment, double gap, double e) {
    constexpr int n = 5;
    constexpr double speed = 2;
    Scene scene = open_line();
    scene.materials[0].restitution = std::sqrt(e);
    for (int i = 0; i < n; ++i)
        add_ball(scene, {(0.2 + gap) * i - (i == 0 ? 0.5 : 0), 0}, {i == 0 ? speed : 0, 0});
    Trial trial(experiment, scene);
    // The velocity that the first impact gives to the last ball; later impacts may add to it.
    double first_pass = no_number;
    trial.run_to(1, [&] {
        for (const Event& impact : trial.impacts())
            if (impact.other == Other::ball(n - 1) || impact.ball == n - 1)
                if (std::isnan(first_pass)) first_pass = impact.impulse / scene.balls.back().mass;
    });
    const std::string of = ", e = " + text_of(e) + ", gap " + text_of(gap) + " m";
    experiment.exact("last ball after the first pass" + of, "m/s", speed * std::pow((1 + e) / 2, n - 1),
                     first_pass, 1e-12);
    if (e < 1) return;
    double others = 0;
    for (BallNumber i = 0; i + 1 < n; ++i) others = std::max(others, std::abs(trial.ball(i).velocity.x));
    experiment.exact("fastest of the others" + of, "m/s", 0, others, 1e-12);
}

void head_on_with(Experiment& experiment, double ratio, double e) {
    constexpr double epsilon = 0x1p-53, first = 3, second = -1;
    Scene scene = open_line();
    scene.materials[0].restitution = std::sqrt(e);
    add_ball(scene, {-1, 0}, {first, 0}, 0.1, ratio);
    add_ball(scene, {1, 0}, {second, 0}, 0.2, 1);
    Trial trial(experiment, scene);
    trial.run_to(0.6);
    const double v = trial.ball(0).velocity.x, w = trial.ball(1).velocity.x;
    const double exact = ((ratio - e) * first + (1 + e) * second) / (ratio + 1);
    const std::string of = ", M/m = " + text_of(ratio) + ", e = " + text_of(e);
    experiment.exact("first ball after" + of, "m/s", exact, v, 1e-14 * first);
    // Against the sum of what both carry, as the total may vanish.
    experiment.exact("momentum residual, relative" + of, "", 0,
                     (ratio * (v - first) + (w - second)) / (ratio * first - second), 2 * epsilon);
}

void stacked_drop_with(Experiment& experiment, double big, double small) {
    constexpr double gap = 1e-7;
    Scene scene = open_line({0, -g});
    add_part(scene, segment({-1, 0}, {1, 0}));
    add_ball(scene, {0, 1.2}, {}, 0.2, big);
    add_ball(scene, {0, 1.5 + gap}, {}, 0.1, small);
    Trial trial(experiment, scene);
    trial.run_to(0.55);
    // Both have fallen for as long and turn at ±v, whatever the gap.
    const double fall = std::sqrt(2 / g), v = std::sqrt(2 * g);
    experiment.exact("upper ball leaves, M/m = " + text_of(big / small), "m/s",
                     v * (3 * big - small) / (big + small),
                     trial.ball(1).velocity.y + g * (trial.time() - fall), 1e-9);
}

void opposed_with(Experiment& experiment, double speed, double offset) {
    Scene scene = open_line();
    add_ball(scene, {-1, 0}, {speed, 0});
    add_ball(scene, {1, offset}, {-2 * speed, 0});
    Trial trial(experiment, scene);
    const double exact = (2 - std::sqrt(0.04 - offset * offset)) / (3 * speed);
    const auto hit = trial.first_impact(10 * exact + 1);
    const std::string of = ", " + text_of(10 * speed) + " r/s" + (offset > 0 ? ", off centre" : "");
    experiment.exact("time of the hit, relative error" + of, "", 0, hit ? hit->time / exact - 1 : no_number,
                     1e-12);
    if (offset == 0)
        experiment.always("passed through each other" + of, "", 0,
                          trial.ball(0).position.x < trial.ball(1).position.x ? 0 : 1);
}

}  // namespace

void galperin(Experiment& experiment) {
    constexpr double digits[] = {3, 31, 314, 3141, 31415, 314159};
    const int most = experiment.size(5, 3);
    for (int k = 0; k <= most; ++k) {
        const std::string quantity = "collisions, M/m = 100^" + text_of(k);
        experiment.attempt(quantity, [&] {
            Scene scene = open_line();
            add_part(scene, segment({0, -1}, {0, 1}));
            add_ball(scene, {2, 0}, {0, 0}, 0.1, 1);
            add_ball(scene, {3, 0}, {-1, 0}, 0.1, std::pow(100.0, k));
            Trial trial(experiment, scene);
            trial.run_to(150);  // both are long on their way from the wall, the light one no faster
            experiment.exact(quantity, "", digits[k], static_cast<double>(trial.impact_count()), 0);
        });
    }
}

void channel(Experiment& experiment) {
    constexpr int n = 20;
    constexpr double r = 0.1, width = 10;
    Scene scene = open_line();
    add_part(scene, segment({0, -1}, {0, 1}));
    add_part(scene, segment({width, -1}, {width, 1}));
    std::vector<Free> points;
    for (int i = 0; i < n; ++i) {
        points.push_back({0.1 + 0.28 * i + 0.05 * math::sin(7.0 * i), 3 * math::sin(1.0 + 2.3 * i)});
        add_ball(scene, {points.back().x + (2 * i + 1) * r, 0}, {points.back().v, 0}, r);
    }
    const int seconds = experiment.size(60, 10);
    Trial trial(experiment, scene);
    trial.run_to(seconds);
    std::vector<double> free;
    for (const Free& point : points) free.push_back(unfolded(point, trial.time(), width - 2 * n * r));
    experiment.exact("worst place of 20 balls after " + text_of(seconds) + " s, error", "m", 0,
                     worst_of_row(trial, free, r, &Vec2::x), 1e-10);
}

void column(Experiment& experiment) {
    constexpr int n = 10;
    constexpr double r = 0.1;
    Scene scene = open_line({0, -g});
    add_part(scene, segment({-1, 0}, {1, 0}));
    std::vector<double> heights;
    for (int i = 0; i < n; ++i) {
        heights.push_back(0.05 + 0.21 * i + 0.03 * math::sin(5.0 * i));
        add_ball(scene, {0, heights.back() + (2 * i + 1) * r}, {}, r);
    }
    Trial trial(experiment, scene);
    trial.run_to(10);
    std::vector<double> free;
    for (const double height : heights) {
        const double fall = std::sqrt(2 * height / g);
        const double t = std::fmod(trial.time() + fall, 2 * fall) - fall;
        free.push_back(height - g * t * t / 2);
    }
    experiment.exact("worst height of 10 balls after 10 s, error", "m", 0,
                     worst_of_row(trial, free, r, &Vec2::y), 1e-9);
}

void cradle(Experiment& experiment) {
    for (const double gap : {1e-6, 0.0})
        for (const double e : {1.0, 0.9})
            experiment.attempt("cradle, e = " + text_of(e) + ", gap " + text_of(gap) + " m",
                               [&] { cradle_with(experiment, gap, e); });
}

void head_on(Experiment& experiment) {
    for (const double ratio : {1.0, 10.0, 1e3, 1e6})
        for (const double e : {1.0, 0.5, 0.0}) head_on_with(experiment, ratio, e);
}

void stacked_drop(Experiment& experiment) {
    stacked_drop_with(experiment, 1, 0.1);
    stacked_drop_with(experiment, 1, 1e-4);
}

void opposed_balls(Experiment& experiment) {
    for (const double speed : {1e1, 1e3, 1e5})
        for (const double offset : {0.0, 0.15}) opposed_with(experiment, speed, offset);
}

}  // namespace flipside::lab
