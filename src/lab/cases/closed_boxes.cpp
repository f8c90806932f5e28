// What nothing may leave.

#include <algorithm>
#include <cmath>

#include "lab/cases/families.hpp"
#include "lab/scenes/dice.hpp"
#include "world/limits.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

/// Elastic walls around [0, side]².
Scene closed_box(double side, double restitution) {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    scene.bounds = {{-side, -side}, {2 * side, 2 * side}};
    add_part(scene, {shape::Polyline{{{0, 0}, {side, 0}, {side, side}, {0, side}}, true}},
             {"", restitution, 0, 0});
    return scene;
}

double outside(const Trial& trial, double side) {
    return static_cast<double>(std::ranges::count_if(trial.world().balls(), [&](const Ball& ball) {
        return !Box{{0, 0}, {side, side}}.contains(ball.position);
    }));
}

}  // namespace

void radius_ratio(Experiment& experiment) {
    constexpr double side = 4, large = 1, small = large / 500;
    const double seconds = experiment.size(30.0, 3.0);
    Scene scene = closed_box(side, 1);
    Dice dice(1);
    add_ball(scene, {2, 2}, dice.direction(), large, large * large);
    // Sizes between, around it: none overlaps another.
    for (int i = 0; i < 79; ++i) {
        const double r = i % 8 == 0 ? 0.05 : small;
        const int column = i / 2;
        const double along = 0.1 + 3.8 * column / 40;
        add_ball(scene, i % 2 == 0 ? Vec2{along, 0.1} : Vec2{along, 3.9}, 2 * dice.direction(), r, r * r);
    }
    Trial trial(experiment, scene);
    const double energy = trial.energy();
    trial.run_to(seconds);
    experiment.exact("balls lost or outside", "", 0,
                     outside(trial, side) + static_cast<double>(trial.lost_count()), 0);
    experiment.exact("energy drift, relative", "", 0, trial.energy() / energy - 1, 1e-11);
}

void gaining_walls(Experiment& experiment) {
    constexpr double side = 2, seconds = 10;
    Scene scene = closed_box(side, 1.3);
    add_ball(scene, {1, 1}, {0.3, 1}, radius);
    add_ball(scene, {1.4, 1.3}, {-1, 0.2}, radius);
    Trial trial(experiment, scene);
    double refused = 0, fastest = 0;
    try {
        while (trial.time() < seconds) {
            trial.step();
            for (const Ball& ball : trial.world().balls()) fastest = std::max(fastest, length(ball.velocity));
        }
    } catch (const Refusal&) {
        refused = 1;
    }
    experiment.exact("refused", "", 1, refused, 0);
    experiment.exact("balls lost or outside", "", 0,
                     outside(trial, side) + static_cast<double>(trial.lost_count()), 0);
    experiment.always("speeds above the top speed", "", 0, fastest > top_speed ? 1 : 0);
}

}  // namespace flipside::lab
