#pragma once
/// How much a report measures.

#include <string>
#include <vector>

#include "lab/borders/borders.hpp"
#include "lab/sweep/variants.hpp"

namespace flipside::lab::report {

struct Effort {
    std::string name;     ///< data of one effort do not mix with those of another
    std::string warning;  ///< "" or what is to be known before anything is believed
    std::string windows;  ///< what of a sweep is run, and
    std::string runs;     ///< what else, in words
    std::vector<sweep::Variant> variants;
    bool quick_sweep;                   ///< as `flipside sweep --quick`
    double sweep_seconds;               ///< CPU time it takes, about
    std::vector<std::string> cases;     ///< by name; all where none is named
    bool quick_cases;                   ///< as `flipside cases --quick`
    double case_seconds;                ///< CPU time they take on one engine, about
    std::vector<double> case_steps;     ///< s, at which some cases are repeated
    std::size_t most_border_values;     ///< that are tried of each border (lab/borders)
    std::vector<sweep::Variant> tuned;  ///< for which settings are searched
    std::size_t tuning_windows;
    int tuning_finest;           ///< steps per second at most
    double tuning_seconds;       ///< CPU time that takes for each, about
    double most_tuning_seconds;  ///< CPU time that a search takes at most, about
    int most_regime_balls;       ///< courses (lab/regimes) of more balls are left out
    int regime_repeats;
    double energy_seconds;
    int gas_balls;
    double divergence_seconds;
    int rain_balls;  ///< of the penetration
    double rain_seconds;
    std::vector<int> growth_balls;  ///< rain with these numbers of balls
    double growth_seconds;          ///< simulated, for each of them
    double growth_limit;            ///< CPU seconds after which such a run is given up
    double pair_seconds;            ///< simulated, of the toy's experiment, for each number of balls
    std::size_t most_pair_balls;    ///< in the growth of broad phases
};

[[nodiscard]] inline Effort full_effort() {
    return {.name = "full",
            .warning = "",
            .windows = "up to 500 windows of each scene at steps from 1/30 to 1/7680 s",
            .runs = "all hard cases, regimes of up to 1,000 balls, borders, and growth to 100,000 balls.",
            .variants = sweep::standard_variants(),
            .quick_sweep = false,
            .sweep_seconds = 400,
            .cases = {},
            .quick_cases = false,
            .case_seconds = 30,
            .case_steps = {1. / 30, 1. / 60, 1. / 120, 1. / 240, 1. / 480, 1. / 960, 1. / 1920},
            .most_border_values = whole_ladders,
            .tuned = sweep::standard_variants(),
            .tuning_windows = 25,
            .tuning_finest = 480,
            .tuning_seconds = 150,
            .most_tuning_seconds = 300,
            .most_regime_balls = 1000,
            .regime_repeats = 6,
            .energy_seconds = 6,
            .gas_balls = 200,
            .divergence_seconds = 10,
            .rain_balls = 300,
            .rain_seconds = 5,
            .growth_balls = {100, 320, 1000, 3200, 10'000, 32'000, 100'000},
            .growth_seconds = 1,
            .growth_limit = 20,
            .pair_seconds = 60,
            .most_pair_balls = 100'000};
}
[[nodiscard]] inline Effort quick_effort() {
    return {
        .name = "quick",
        .warning =
            "A quick report: intervals are wide and times rough. Decide by a full one (without --quick).",
        .windows = "up to 40 windows of each scene at steps from 1/30 to 1/960 s",
        .runs =
            "the hard cases in short form, regimes of up to 500 balls, borders, and growth to 3,200 balls.",
        .variants = sweep::standard_variants(),
        .quick_sweep = true,
        .sweep_seconds = 60,
        .cases = {},
        .quick_cases = true,
        .case_seconds = 2,
        .case_steps = {1. / 30, 1. / 120, 1. / 480},
        .most_border_values = whole_ladders,
        .tuned = {sweep::standard_variants().front()},
        .tuning_windows = 25,
        .tuning_finest = 480,
        .tuning_seconds = 2,
        .most_tuning_seconds = 20,
        .most_regime_balls = 500,
        .regime_repeats = 3,
        .energy_seconds = 3,
        .gas_balls = 100,
        .divergence_seconds = 5,
        .rain_balls = 100,
        .rain_seconds = 3,
        .growth_balls = {100, 320, 1000, 3200},
        .growth_seconds = 0.5,
        .growth_limit = 3,
        .pair_seconds = 10,
        .most_pair_balls = 32'000};
}

}  // namespace flipside::lab::report
