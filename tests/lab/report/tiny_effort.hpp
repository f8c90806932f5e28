#pragma once
/// A report that takes seconds: everything is measured, of everything a little.

#include "lab/report/effort.hpp"

namespace flipside::lab::report {

inline Effort tiny_effort() {
    Effort effort = quick_effort();
    effort.name = "tiny";
    effort.cases = {"zeno-drop", "galperin", "column", "bowl", "incline"};
    effort.case_steps = {1. / 30, 1. / 60};
    effort.most_border_values = 2;
    effort.tuned.clear();
    effort.most_regime_balls = 1;
    effort.regime_repeats = 2;
    effort.energy_seconds = 0.2;
    effort.gas_balls = 9;
    effort.divergence_seconds = 0.7;
    effort.rain_balls = 10;
    effort.rain_seconds = 0.2;
    effort.growth_balls = {10, 20};
    effort.growth_seconds = 0.1;
    effort.pair_seconds = 0.05;
    effort.most_pair_balls = 100;
    return effort;
}

}  // namespace flipside::lab::report
