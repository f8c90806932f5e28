// Chaotic motion without gravity: trajectories are unknowable, averages are known. Every world starts from
// seeded random states, and the spread between the worlds gives the confidence interval.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "lab/scenes/dice.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

using std::numbers::pi;

constexpr double speed = 4;  // m/s, of every ball at the start: two thirds of a radius in a step of 1/60 s

/// Elastic walls around [0, side]².
Scene walled(double side) {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    add_part(scene, {shape::Polyline{{{0, 0}, {side, 0}, {side, side}, {0, side}}, true}});
    return scene;
}

/// n balls on a lattice in [0, side]², jittered, in all directions.
void fill(Scene& scene, int n, double side, Dice& dice) {
    const int columns = static_cast<int>(std::ceil(std::sqrt(n)));
    const double pitch = (side - 2 * radius) / columns, play = std::min(pitch - 2 * radius, pitch / 2);
    for (int i = 0; i < n; ++i) {
        const int row = i / columns;
        const Vec2 cell{radius + (i % columns + 0.5) * pitch, radius + (row + 0.5) * pitch};
        const Vec2 jitter{dice.below(play) - play / 2, dice.below(play) - play / 2};
        add_ball(scene, cell + jitter, speed * dice.direction(), radius);
    }
}

double kinetic(const Ball& ball) {
    return 0.5 * ball.mass * length_squared(ball.velocity);
}

/// Σ m·r·v, whose change over any time is 2·K·t + Σ r·J: the virial theorem of hard discs, exactly.
double moment(const Trial& trial) {
    double sum = 0;
    for (const Ball& ball : trial.world().balls()) sum += ball.mass * dot(ball.position, ball.velocity);
    return sum;
}

/// What one world of the gas gives.
struct GasSample {
    double packing;   ///< share of the area that discs cover, clear of the walls
    double pressure;  ///< Z = P/(ρkT) there
    double virial;    ///< residual of the virial theorem over 2·K·t
    double energy;    ///< drift, relative
};

/// Impulses and kinetic energy are counted in a square clear of the layers along the walls, so that a density
/// which is off there for a while is off in the pressure and in the packing alike.
GasSample gas_sample(Experiment& experiment, double side, int n, std::uint64_t seed) {
    constexpr double settling = 0.5;  // s, several impacts per ball at the least
    const double seconds = experiment.size(6.0, 1.5), margin = std::min(side / 4, 8 * radius);
    const Box middle{{margin, margin}, {side - margin, side - margin}};
    Scene scene = walled(side);
    Dice dice(seed);
    fill(scene, n, side, dice);
    Trial trial(experiment, scene);
    trial.run_to(settling);

    const double from = trial.time(), moment_first = moment(trial), twice_k = 2 * trial.energy();
    double pair_virial = 0, energy_time = 0, count_time = 0;  // in the middle
    double all_virial = 0;
    double last = from;
    trial.run_to(from + seconds, [&] {
        const double dt = trial.time() - last;
        last = trial.time();
        for (const Ball& ball : trial.world().balls()) {
            if (!middle.contains(ball.position)) continue;
            energy_time += kinetic(ball) * dt;
            count_time += dt;
        }
        for (const Event& impact : trial.impacts()) {
            const double pair = 2 * radius * impact.impulse;
            const double wall = impact.impulse * dot(impact.point + radius * impact.normal, impact.normal);
            all_virial += impact.other.is_ball ? pair : wall;
            if (impact.other.is_ball && middle.contains(impact.point)) pair_virial += pair;
        }
    });
    const double t = trial.time() - from, area = (side - 2 * margin) * (side - 2 * margin);
    return {count_time / t * pi * radius * radius / area, 1 + pair_virial / (2 * energy_time),
            (moment(trial) - moment_first - twice_k * t - all_virial) / (twice_k * t),
            2 * trial.energy() / twice_k - 1};
}

/// Z at packing `eta` by D. Henderson, A simple equation of state for hard discs, 1975; good to 1 %.
double henderson(double eta) {
    return (1 + eta * eta / 8) / ((1 - eta) * (1 - eta));
}

/// By the virial coefficients B_n/B_2^(n−1) of N. Clisby and B. M. McCoy, Ninth and tenth order virial
/// coefficients for hard spheres in D dimensions, 2006, and beyond them a geometric series: good to 0.1 % up
/// to eta = 0.5, where that is 0.6 % of the whole.
double virial_series(double eta) {
    constexpr double coefficients[] = {1,         1,          0.78200444, 0.53223180, 0.33355604,
                                       0.1988425, 0.11486728, 0.0649930,  0.0362193,  0.0199537};
    double sum = 0, power = 1, last = 0, before = 0;
    for (const double coefficient : coefficients) {
        before = last, last = coefficient * power;
        sum += last;
        power *= 2 * eta;
    }
    const double ratio = last / before;
    return sum + last * ratio / (1 - ratio);
}

/// How large a gas is, and how well its pressure must be known.
struct GasSize {
    int balls;
    std::uint64_t worlds;
    double (*pressure)(double);
    double error;   ///< of that, relative
    double needed;  ///< half width of the confidence interval
};

void gas_at(Experiment& experiment, double nominal, const GasSize& gas) {
    const int n = gas.balls;
    const std::uint64_t worlds = gas.worlds;
    const double side = std::sqrt(n * pi * radius * radius / nominal);
    std::vector<double> excess;
    double packing = 0, virial = 0, energy = 0;
    for (std::uint64_t seed = 1; seed <= worlds; ++seed) {
        const GasSample sample = gas_sample(experiment, side, n, seed);
        const double eta = sample.packing;
        excess.push_back(sample.pressure / gas.pressure(eta));
        packing += eta / static_cast<double>(worlds);
        virial = std::max(virial, std::abs(sample.virial));
        energy = std::max(energy, std::abs(sample.energy));
    }
    const std::string of = ", eta = " + text_of(nominal) + ", " + text_of(n) + " balls";
    experiment.note("packing in the middle" + of, "", packing, nominal);
    experiment.statistic("Z over that of theory" + of, "", 1, estimate(excess), gas.error, gas.needed);
    experiment.exact("energy drift, worst, relative" + of, "", 0, energy, 1e-12);
    experiment.exact("virial theorem, worst residual" + of, "", 0, virial, 1e-9);
}

}  // namespace

void mean_free_path(Experiment& experiment) {
    // What the centre of the ball can reach: a square less a quarter of a disc in each corner and a disc in
    // the middle, which stands in the way of all that would bounce between two parallel walls for long.
    constexpr double inner = 1, side = inner + 2 * radius, corner = 0.4, pin = 0.2;
    constexpr double area = inner * inner - pi * corner * corner - pi * pin * pin;
    constexpr double perimeter = 4 * (inner - 2 * corner) + 2 * pi * corner + 2 * pi * pin;
    const double seconds = experiment.size(1000.0, 60.0);
    std::vector<double> paths;
    double lost = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Scene scene = walled(side);
        for (const double x : {0.0, inner})
            for (const double y : {0.0, inner})
                add_part(scene, {shape::Circle{{radius + x, radius + y}, corner - radius}});
        add_part(scene, {shape::Circle{{side / 2, side / 2}, pin - radius}});
        Dice dice(seed);
        const double along = dice.below(inner - 2 * corner);  // a wall that no pin covers
        add_ball(scene, {radius + corner + along, radius + 0.01}, speed * dice.direction(), radius);
        Trial trial(experiment, scene);
        double way = 0;
        trial.run_to(seconds, [&] { way += length(trial.ball(0).velocity) * experiment.dt(); });
        paths.push_back(way / static_cast<double>(trial.impact_count()));
        lost += static_cast<double>(trial.lost_count());
    }
    constexpr double expected = pi * area / perimeter;
    experiment.statistic("mean free path", "m", expected, estimate(paths), 0,
                         expected * experiment.size(0.007, 0.025));
    experiment.always("balls lost", "", 0, lost);
}

void disc_gas(Experiment& experiment) {
    const GasSize size{experiment.size(200, 100), experiment.size<std::uint64_t>(16, 20), henderson, 0.01,
                       experiment.size(0.012, 0.05)};
    for (const double packing : {0.1, 0.3, 0.5})
        experiment.attempt("gas, eta = " + text_of(packing), [&] { gas_at(experiment, packing, size); });
}

void impact_statistics(Experiment& experiment) {
    const GasSize size{experiment.size(500, 200), experiment.size<std::uint64_t>(16, 14), virial_series,
                       0.001, experiment.size(0.004, 0.04)};
    for (const double packing : {0.1, 0.3, 0.5})
        experiment.attempt("gas, eta = " + text_of(packing), [&] { gas_at(experiment, packing, size); });
}

void equipartition(Experiment& experiment) {
    constexpr double masses[] = {1, 4, 16};
    constexpr int n = 30;
    constexpr double side = 1.8;
    const double settling = experiment.size(10.0, 5.0), seconds = experiment.size(300.0, 40.0);
    const auto worlds = experiment.size<std::uint64_t>(12, 8);
    std::vector<double> shares[3];
    double lost = 0;
    for (std::uint64_t seed = 1; seed <= worlds; ++seed) {
        Scene scene = walled(side);
        Dice dice(seed);
        fill(scene, n, side, dice);
        for (Ball& ball : scene.balls) ball.mass = masses[ball.number % 3];
        Trial trial(experiment, scene);
        trial.run_to(settling);
        double energies[3] = {};
        trial.run_to(settling + seconds, [&] {
            for (const Ball& ball : trial.world().balls()) energies[ball.number % 3] += kinetic(ball);
        });
        const double all = energies[0] + energies[1] + energies[2];
        for (std::size_t kind = 0; kind < 3; ++kind) shares[kind].push_back(3 * energies[kind] / all);
        lost += static_cast<double>(trial.lost_count());
    }
    for (std::size_t kind = 0; kind < 3; ++kind)
        experiment.statistic("energy over the mean, mass " + text_of(masses[kind]), "", 1,
                             estimate(shares[kind]), 0, experiment.size(0.015, 0.07));
    experiment.always("balls lost", "", 0, lost);
}

}  // namespace flipside::lab
