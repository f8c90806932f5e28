// Balls in a row.

#include <cmath>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

/// Elastic, without gravity, too wide to leave.
Scene frictionless_line() {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
    return scene;
}

}  // namespace

void galperin(Experiment& experiment) {
    constexpr double digits[] = {3, 31, 314, 3141, 31415, 314159};
    const int most = experiment.size(5, 3);
    for (int k = 0; k <= most; ++k) {
        Scene scene = frictionless_line();
        add_part(scene, segment({0, -1}, {0, 1}));
        add_ball(scene, {2, 0}, {0, 0}, 0.1, 1);
        add_ball(scene, {3, 0}, {-1, 0}, 0.1, std::pow(100.0, k));
        Trial trial(experiment, scene);
        // All is over when both fly away from the wall, the light one no faster.
        const bool whole = trial.run_to(150);
        experiment.exact("collisions, M/m = 100^" + text_of(k), "", digits[k],
                         whole ? static_cast<double>(trial.impact_count()) : no_number, 0);
    }
}

}  // namespace flipside::lab
