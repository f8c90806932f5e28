// A ball that slides off the flat of a part onto its round end.

#include <cmath>
#include <numbers>

#include "lab/cases/families.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

/// A part with its upper side above the x axis, and where a ball slides on it.
struct Flat {
    std::string name;
    Shape shape;
    double slope = 0;   ///< of the upper side, rad
    double height = 0;  ///< of the ball's centre above the side's line through the origin, m
};

/// The base lies at the origin, the tip along `angle`.
Flat capsule_at(double angle) {
    const double cap = 2 * radius;
    return {"capsule", {shape::Capsule{{}, 0.5 * from_angle(angle), cap}}, 0, cap + radius};
}
Flat flipper_at(double angle) {
    const double base = 2.5 * radius, tip = 1.5 * radius, reach = 0.6;
    // The side's outward normal makes the angle acos((base − tip)/reach) with the axis.
    const double slope = std::acos((base - tip) / reach) - std::numbers::pi / 2;
    return {"flipper", {shape::Flipper{{}, reach, base, tip, angle}}, slope, base + radius};
}

void slide_off(Experiment& experiment, Flat (*flat_at)(double), int orientations) {
    constexpr double way = 1.2, speed = 1;  // m, of which the flat is at most half; m/s
    double worst = 0;
    int faster = 0;
    for (int k = 0; k < orientations; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.25) / orientations;
        const Flat flat = flat_at(angle);
        const Vec2 along = from_angle(angle + flat.slope), start = flat.height * perp(along) + 0.1 * along;
        Scene scene = empty_scene();
        add_part(scene, flat.shape, {"", 0, 0, 0});
        add_ball(scene, start, speed * along, radius);
        Trial trial(experiment, scene);
        trial.run_to(way / speed);
        const Ball ball = trial.ball(0);
        const double stray = length(ball.position - (start + way * along)) / radius;
        if (!(stray <= worst)) worst = stray;  // that of a lost ball is no number
        faster += length(ball.velocity) > 1.001 * speed ? 1 : 0;
    }
    const std::string of = ", " + flat_at(0).name + ", " + std::to_string(orientations) + " orientations";
    experiment.exact("farthest from a straight line" + of, "r", 0, worst, 1e-12);
    experiment.always("balls that gained speed" + of, "", 0, faster);
}

}  // namespace

void smooth_joint(Experiment& experiment) {
    const int orientations = experiment.size(1000, 100);
    experiment.attempt("capsule", [&] { slide_off(experiment, capsule_at, orientations); });
    experiment.attempt("flipper", [&] { slide_off(experiment, flipper_at, orientations); });
}

}  // namespace flipside::lab
