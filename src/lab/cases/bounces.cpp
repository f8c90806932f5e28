// One ball that falls and bounces.

#include <algorithm>
#include <cmath>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

constexpr double g = 9.81;  // m/s²
constexpr double epsilon = 0x1p-53;

/// A ball of radius 0.1 m whose lowest point is `height` above a floor.
Scene bouncing(double height, double restitution) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    add_ball(scene, {0, height + 0.1});
    add_part(scene, segment({-1, 0}, {1, 0}), {"", restitution, 0, 0});
    return scene;
}

void zeno_drop_with(Experiment& experiment, double e) {
    constexpr std::size_t compared = 15;  // impacts; the last ones are below 1 mm/s for e = 0.5
    Trial trial(experiment, bouncing(1, e));
    const double fall = std::sqrt(2 / g), rest = fall * (1 + e) / (1 - e);
    std::vector<Event> impacts;
    bool whole = true;
    while (whole && trial.time() < rest + 1) {
        whole = trial.step();
        std::ranges::copy(trial.impacts(), std::back_inserter(impacts));
    }
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
                     whole && !impacts.empty() ? impacts.back().time : no_number, 2e-8 * rest);
    experiment.exact("speed one second later" + of, "m/s", 0, length(trial.ball(0).velocity), 0);
    experiment.exact("height of rest" + of, "m", 0.1, trial.ball(0).position.y, 1e-15);
}

}  // namespace

void zeno_drop(Experiment& experiment) {
    for (const double e : {0.5, 0.8, 0.9}) zeno_drop_with(experiment, e);
}

void elastic_drop(Experiment& experiment) {
    const auto wanted = experiment.size<std::uint64_t>(100'000, 2'000);
    Trial trial(experiment, bouncing(0.05, 1));
    const double first = trial.energy();
    while (trial.impact_count() < wanted && trial.step()) continue;
    const auto bounces = static_cast<double>(trial.impact_count());
    const double drift = trial.energy() / first - 1;
    experiment.exact("bounces", "", static_cast<double>(wanted),
                     trial.impact_count() < wanted ? no_number : static_cast<double>(wanted), 0);
    experiment.exact("energy drift, relative", "", 0, drift, 4 * bounces * epsilon);
    experiment.note("energy drift per bounce, relative", "", drift / bounces, 0);
}

}  // namespace flipside::lab
