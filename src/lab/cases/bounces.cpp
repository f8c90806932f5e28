// One ball that falls and bounces.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

/// A ball whose lowest point is `height` above a floor, `origin` being the point of the floor below it.
Scene bouncing(double height, double restitution, Vec2 origin = {}) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    scene.bounds = {{-1e8, -1e8}, {1e8, 1e8}};
    add_ball(scene, origin + Vec2{0, height + radius}, {}, radius);
    add_part(scene, segment(origin - Vec2{1, 0}, origin + Vec2{1, 0}), {"", restitution, 0, 0});
    return scene;
}

void zeno_drop_with(Experiment& experiment, double e) {
    constexpr std::size_t compared = 15;  // impacts; the last ones are below 1 mm/s for e = 0.5
    Trial trial(experiment, bouncing(1, e));
    const double fall = std::sqrt(2 / g), rest = fall * (1 + e) / (1 - e);
    std::vector<Event> impacts;
    trial.run_to(rest + 1, [&] { std::ranges::copy(trial.impacts(), std::back_inserter(impacts)); });
    double time_error = 0, speed_error = 0;
    double time = fall, speed = std::sqrt(2 * g);
    for (std::size_t n = 0; n < std::min(compared, impacts.size()); ++n) {
        time_error = std::max(time_error, std::abs(impacts[n].time / time - 1));
        speed_error = std::max(speed_error, std::abs(impacts[n].speed / speed - 1));
        speed *= e;
        time += 2 * speed / g;
    }
    if (impacts.size() < compared) time_error = speed_error = no_number;
    const std::string of = ", e = " + text_of(e);
    const std::string first = " of the first " + text_of(compared) + " impacts, relative error";
    experiment.exact("times" + first + of, "", 0, time_error, 1e-9);
    experiment.exact("speeds" + first + of, "", 0, speed_error, 1e-9);
    experiment.exact("time of the last impact" + of, "s", rest,
                     impacts.empty() ? no_number : impacts.back().time, 2e-8 * rest);
    experiment.exact("speed one second later" + of, "m/s", 0, length(trial.ball(0).velocity), 0);
    experiment.exact("height of rest" + of, "m", radius, trial.ball(0).position.y, 1e-15);
}

/// In a V each coordinate normal to a wall is a Zeno drop of its own under g/√2.
double rest_in_v(double e, Vec2 start) {
    const double diagonal = std::sqrt(2.0), a = g / diagonal;
    double rest = 0;
    for (const double x : {start.x, -start.x}) {
        const double height = (x + start.y) / diagonal - radius;
        rest = std::max(rest, std::sqrt(2 * height / a) * (1 + e) / (1 - e));
    }
    return rest;
}

struct Spinning {
    Vec2 velocity;
    double spin, friction;
    std::string_view name;
};

/// Against a floor, without gravity: J_n = (1+e)·m·|v_n|, |J_t| = min(µ·J_n, m·|v_t + r·ω|/3).
void bounce_with(Experiment& experiment, const Spinning& start) {
    constexpr double e = 0.8, mass = 0.5;
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    scene.materials[0].friction = start.friction;
    Ball& ball = add_ball(scene, {0, 0.5}, start.velocity, radius, mass);
    ball.spin = start.spin;
    add_part(scene, segment({-50, 0}, {50, 0}), {"", e, start.friction, 0});
    Trial trial(experiment, scene);
    trial.run_to(0.4);

    const double normal = (1 + e) * mass * -start.velocity.y, slip = start.velocity.x + radius * start.spin;
    const double tangential = std::min(start.friction * normal, mass * std::abs(slip) / 3);
    const double along = slip > 0 ? -tangential : tangential;
    const std::string of = ", " + std::string(start.name);
    experiment.exact("normal speed after" + of, "m/s", -e * start.velocity.y, trial.ball(0).velocity.y,
                     1e-12);
    experiment.exact("tangential speed after" + of, "m/s", start.velocity.x + along / mass,
                     trial.ball(0).velocity.x, 1e-12);
    experiment.exact("spin after" + of, "rad/s", start.spin + along * radius / (0.5 * mass * radius * radius),
                     trial.ball(0).spin, 1e-11);
}

}  // namespace

void zeno_drop(Experiment& experiment) {
    for (const double e : {0.5, 0.8, 0.9})
        experiment.attempt("drop, e = " + text_of(e), [&] { zeno_drop_with(experiment, e); });
}

void elastic_drop(Experiment& experiment) {
    constexpr double epsilon = 0x1p-53;
    const auto wanted = experiment.size<std::uint64_t>(100'000, 2'000);
    Trial trial(experiment, bouncing(0.05, 1));
    const double first = trial.energy();
    while (trial.impact_count() < wanted && trial.may_step()) trial.step();
    const auto bounces = static_cast<double>(trial.impact_count());
    const double drift = trial.energy() / first - 1;
    const auto all = static_cast<double>(wanted);
    if (bounces < all) experiment.cut_short();
    experiment.exact("bounces", "", all, bounces < all ? no_number : all, 0);
    experiment.exact("energy drift, relative", "", 0, drift, 4 * bounces * epsilon);
    experiment.note("energy drift per bounce, relative", "", drift / bounces, 0);
    experiment.always("balls lost", "", 0, static_cast<double>(trial.lost_count()));
}

void v_corner(Experiment& experiment) {
    constexpr double e = 0.5;
    const Vec2 start{0.1, 0.6};
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_ball(scene, start, {}, radius);
    add_part(scene, {shape::Polyline{{{-2, 2}, {0, 0}, {2, 2}}, false}}, {"", e, 0, 0});
    Trial trial(experiment, scene);
    const double rest = rest_in_v(e, start);
    double last = no_number;
    trial.run_to(rest + 1, [&] {
        for (const Event& impact : trial.impacts()) last = impact.time;
    });
    experiment.exact("time of the last impact", "s", rest, last, 2e-8 * rest);
    experiment.exact("speed one second later", "m/s", 0, length(trial.ball(0).velocity), 0);
    experiment.exact("place of rest, x", "m", 0, trial.ball(0).position.x, 1e-12);
    experiment.exact("place of rest, y", "m", radius * std::sqrt(2.0), trial.ball(0).position.y, 1e-12);
}

void far_away(Experiment& experiment) {
    for (const double radii : {1e3, 1e5, 1e7}) {
        const std::string at = " at " + text_of(radii) + " radii";
        experiment.attempt("drop" + at, [&] {
            const Vec2 origin{radii * radius, -radii * radius};
            const double e = 0.8, ulp = radii * radius * 0x1p-52;
            const double first = std::sqrt(2 / g), second = first * (1 + 2 * e);
            Trial trial(experiment, bouncing(1, e, origin));
            std::vector<Event> hits;
            trial.run_to(1.3, [&] { std::ranges::copy(trial.impacts(), std::back_inserter(hits)); });
            const double t = trial.time() - second, v = e * e * std::sqrt(2 * g);
            const double height = radius + v * t - g * t * t / 2;
            const auto off = [&](std::size_t n, double exact) {
                return n < hits.size() ? (hits[n].time - exact) / ulp : no_number;
            };
            experiment.exact("error of impact 1" + at, "ulp", 0, off(0, first), 40);
            experiment.exact("error of impact 2" + at, "ulp", 0, off(1, second), 40);
            experiment.exact("error of height" + at, "ulp", 0,
                             (trial.ball(0).position.y - origin.y - height) / ulp, 200);
        });
    }
}

void friction_bounce(Experiment& experiment) {
    constexpr Spinning starts[] = {{{2, -3}, 0, 0.1, "slips"},
                                   {{2, -3}, 40, 0.1, "slips with topspin"},
                                   {{1, -3}, 5, 0.5, "sticks"},
                                   {{-1, -3}, 30, 0.5, "sticks with backspin"}};
    for (const Spinning& start : starts)
        experiment.attempt(std::string(start.name), [&] { bounce_with(experiment, start); });
}

}  // namespace flipside::lab
