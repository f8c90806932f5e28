#include "box2d/engine.hpp"

#include <algorithm>

#include "box2d/world.hpp"

namespace flipside::box2d {

namespace {

constexpr std::string_view on[] = {"on"};
constexpr std::string_view integrators[] = {"euler", "verlet"};

constexpr SettingSpec specs[] = {
    {.name = "velocity_iterations",
     .type = SettingType::integer,
     .initial = 8,
     .min = 1,
     .max = 1000,
     .about = "passes of the velocity solver per sub-step; too few leave heaps and flippers soft",
     .everyday = true},
    {.name = "position_iterations",
     .type = SettingType::integer,
     .initial = 3,
     .min = 1,
     .max = 1000,
     .about =
         "passes that push overlaps out per sub-step; too few let the balls of heaps sink into each other",
     .everyday = true},
    {.name = "substeps",
     .type = SettingType::integer,
     .initial = 1,
     .min = 1,
     .max = 1000,
     .about = "equal parts each step is cut into; more is more accurate and costs in proportion",
     .everyday = true},
    {.name = "bullets",
     .type = SettingType::toggle,
     .initial = 1,
     .about = "continuous collision between balls too; off, fast balls can pass through one another",
     .acts_with = {"continuous", on}},
    {.name = "continuous",
     .type = SettingType::toggle,
     .initial = 1,
     .about = "continuous collision at all; off, a fast ball can pass through a wall",
     .everyday = true},
    {.name = "warm_starting",
     .type = SettingType::toggle,
     .initial = 1,
     .about = "start the solver from the last step's impulses; off, heaps need more iterations",
     .everyday = true},
    {.name = "integrator",
     .type = SettingType::choice,
     .choices = integrators,
     .about = "euler: Box2D's own, gravity before the motion, so flights fall short by g·t·dt/2; verlet: "
              "half of it before and half after, so undamped flights are parabolas to rounding"},
    {.name = "sleep",
     .type = SettingType::toggle,
     .initial = 1,
     .about = "balls at rest for half a second are left out until they are touched"},
    {.name = "length_scale",
     .type = SettingType::real,
     .unit = "1/m",
     .initial = 0,
     .min = 0,
     .max = 1e4,
     .about = "Box2D units per metre, 0: the typical ball gets a diameter of 0.5; too small: its slop of "
              "0.005 units shows; too large: its limit of 2 units per sub-step slows fast balls"},
    {.name = "chord_error",
     .type = SettingType::real,
     .unit = "m",
     .initial = 2e-5,
     .min = 1e-8,
     .max = 1,
     .about = "how far the chords that stand for an arc may stray from it; smaller means more of them"},
};

/// The diameter of the median ball; a pinball's where the scene has none.
double typical_diameter(const Scene& scene) {
    std::vector<double> radii;
    for (const Ball& ball : scene.balls) radii.push_back(ball.radius);
    if (radii.empty()) return scene.launcher ? 2 * scene.launcher->ball.radius : 0.027;
    const auto median = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::ranges::nth_element(radii, median);
    return 2 * *median;
}

std::unique_ptr<World> make(std::shared_ptr<const Scene> scene, const Settings& settings) {
    const double scale = settings.real("length_scale");
    const Options options{
        .velocity_iterations = settings.integer("velocity_iterations"),
        .position_iterations = settings.integer("position_iterations"),
        .substeps = settings.integer("substeps"),
        .bullets = settings.toggle("bullets"),
        .continuous = settings.toggle("continuous"),
        .warm_starting = settings.toggle("warm_starting"),
        .verlet = settings.choice("integrator") == "verlet",
        .sleep = settings.toggle("sleep"),
        .length_scale = scale > 0 ? scale : 0.5 / typical_diameter(*scene),
        .chord_error = settings.real("chord_error"),
    };
    return std::make_unique<Box2dWorld>(std::move(scene), options);
}

const Engine box2d_engine{
    .name = "box2d",
    .about = "single precision, time stepping with an iterative solver, continuous collision",
    .settings = specs,
    .make = make,
    .library = "Box2D " FLIPSIDE_BOX2D_VERSION,
};

}  // namespace

const Engine& engine() {
    return box2d_engine;
}

}  // namespace flipside::box2d
