// Balls that are held from several sides: one in a wedge, and heavy ones on light ones.

#include <algorithm>
#include <cmath>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

constexpr double wedge_steps[] = {1.0 / 37, 1.0 / 60, 1.0 / 240};  // s

/// Steps of `dt` until `end`; visits the world after each.
void run_in_steps(Trial& trial, double dt, double end, auto&& see) {
    while (trial.time() < end - 1e-9) {
        trial.step(std::min(dt, end - trial.time()));
        see();
    }
}

/// A ball falls 1 mm into a right-angled wedge.
void wedge_at(Experiment& experiment, double dt, double friction) {
    constexpr double drop = 1e-3, rest = 0.5;  // m, s
    Scene scene = empty_scene({0, -g});
    scene.materials[0].friction = friction;
    const Material wall{"", 0.5, friction, 0};
    add_part(scene, segment({-2, 2}, {0, 0}), wall);
    add_part(scene, segment({0, 0}, {2, 2}), wall);
    const double height = radius * std::sqrt(2);
    add_ball(scene, {0, height + drop}, {}, radius);
    Trial trial(experiment, scene);
    double last_impact = 0, fastest_late = 0;
    run_in_steps(trial, dt, 1, [&] {
        for (const Event& impact : trial.impacts()) last_impact = impact.time;
        if (trial.time() > rest) fastest_late = std::max(fastest_late, length(trial.ball(0).velocity));
    });
    const std::string at = ", mu = " + text_of(friction) + ", dt = 1/" + text_of(std::lround(1 / dt)) + " s";
    // Both walls at once, n times: 2·√(2h/g)·(½ + e + e² + …), with what is slower than rest_speed left out.
    const double zeno = std::sqrt(2 * drop / g) * 3;
    experiment.exact("last impact before the Zeno time" + at, "", 1, last_impact <= zeno ? 1 : 0, 0);
    experiment.exact("height" + at, "m", height, trial.ball(0).position.y, 1e-9);
    experiment.exact("fastest after 0.5 s" + at, "m/s", 0, fastest_late, 0);
    const auto asleep = static_cast<double>(trial.world().statistics().asleep);
    if (experiment.input().contender.engine->name == "reference")  // where nothing ever sleeps
        experiment.note("asleep" + at, "", asleep);
    else
        experiment.exact("asleep" + at, "", 1, asleep, 0);
}

/// Balls with these masses from below, each on the one before, from side to side of a channel where its width
/// is more than a ball's.
void stack_of(Experiment& experiment, const std::vector<double>& masses, double play,
              const std::string& name) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0.1;
    const double left = -radius - play / 2;
    add_part(scene, {shape::Polyline{{{left, 9}, {left, 0}, {-left, 0}, {-left, 9}}, false}},
             {"", 0.5, 0, 0});
    const double rise = std::sqrt(4 * radius * radius - play * play);
    for (std::size_t i = 0; i < masses.size(); ++i)
        add_ball(scene, {(i % 2 == 0 ? -0.5 : 0.5) * play, radius + static_cast<double>(i) * rise}, {},
                 radius, masses[i]);
    Trial trial(experiment, scene);
    double deepest = 0;
    trial.run_to(2, [&] {
        if (trial.time() > 0.1)
            deepest = std::max(deepest, deepest_overlap(trial.world().contacts()) / radius);
    });
    const auto balls = static_cast<double>(masses.size());
    experiment.exact("deepest overlap after 0.1 s, " + name, "r", 0, deepest, 0.01);
    experiment.exact("asleep after 2 s, " + name, "", balls,
                     static_cast<double>(trial.world().statistics().asleep), 0);
}

}  // namespace

void wedge(Experiment& experiment) {
    for (const double friction : {0.0, 0.3})
        for (const double dt : wedge_steps)
            experiment.attempt("wedge", [&] { wedge_at(experiment, dt, friction); });
}

void heavy_on_light(Experiment& experiment) {
    const auto alternating = [](std::size_t balls) {
        std::vector<double> masses;
        for (std::size_t i = 0; i < balls; ++i) masses.push_back(i % 2 == 0 ? 1 : 1000);
        return masses;
    };
    experiment.attempt("two", [&] { stack_of(experiment, alternating(2), 0, "two"); });
    experiment.attempt("six", [&] { stack_of(experiment, alternating(6), 0, "six"); });
    experiment.attempt("ten", [&] {
        stack_of(experiment, alternating(10), 0.2 * radius, "ten from side to side of a channel");
    });
}

}  // namespace flipside::lab
