#include "app/window/plots.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "app/window/contender_colour.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

std::string in_joules(double value) {
    return engineering(value, "J");
}

std::string in_seconds(double value) {
    return engineering(value, "s");
}

std::string in_tests(double value) {
    return grouped(static_cast<std::uint64_t>(std::llround(std::max(0.0, value))));
}

/// Of the stages of a step: none is an engine's.
const sf::Color stage_colours[] = {colour::boxes, colour::cells, colour::pairs, colour::kicker,
                                   colour::quiet};

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Curve curve_of(const Run& run, const std::string& unit, std::string (*words)(double),
               const std::function<double(const StepNumbers&)>& value) {
    Curve curve{run.name(), colour_of(run), {}, unit, words};
    for (const StepNumbers& numbers : run.numbers()) curve.samples.push_back({numbers.time, value(numbers)});
    return curve;
}

/// In place of nothing where two are together to the last bit: below what is drawn.
Curve distance_curve(std::string name, sf::Color color, const std::deque<Sample>& samples) {
    return {std::move(name), color, {samples.begin(), samples.end()}, "r", in_radii};
}

/// Where gravity became another one.
struct GravityChange {
    double time = 0;  ///< s: end of the last step before
    Vec2 after;       ///< m/s²
};
std::vector<GravityChange> gravity_changes(const Run& run) {
    std::vector<GravityChange> changes;
    const StepNumbers* last = nullptr;
    for (const StepNumbers& numbers : run.numbers()) {
        if (last != nullptr && numbers.gravity != last->gravity)
            changes.push_back({last->time, numbers.gravity});
        last = &numbers;
    }
    return changes;
}

}  // namespace

PlotChoice plots_named(std::string_view name) {
    return std::ranges::find(plot_specs, name, &PlotSpec::name)->choice;
}

Plot distance_plot(const Stage& stage) {
    const Run* exact = stage.exact();
    const Run& base = exact ? *exact : stage.runs().front();
    Plot plot{exact ? "From the reference, in radii" : "From " + base.name() + ", in radii",
              exact ? "Error" : "Apart"};
    plot.scale = Scale::decades;
    plot.bottom = 1e-13;
    plot.top = 1e2;
    for (const Divergence& divergence : stage.divergences()) {
        if (!divergence.is_of(base.name())) continue;
        const Run& other =
            stage.run_named(divergence.first() == base.name() ? divergence.second() : divergence.first());
        Curve& curve =
            plot.curves.emplace_back(distance_curve(other.name(), colour_of(other), divergence.history()));
        // Where nobody knows where the balls truly are, nothing is wrong by so much.
        for (Sample& sample : curve.samples)
            if (!base.is_measure_at(sample.time)) sample.value = not_a_number;
        const auto& parting = divergence.parting();
        if (!parting || parting->time > stage.time() || exact) continue;
        const auto& first = divergence.first_parting();
        plot.note = (first && first->time < parting->time ? "parted again at " : "parted at ") +
                    with_unit(parting->time, 2, "s") + " on " + divergence.parted_on(stage.scene());
        plot.marks.push_back({parting->time, "", colour::text, true});
    }
    if (exact && stage.runs().size() > 1 && !exact->uncertainty_history().empty()) {
        plot.curves.push_back(
            distance_curve(exact->name() + ", at most", colour_of(*exact), exact->uncertainty_history()));
        if (const auto& halt = exact->halt())
            plot.marks.push_back({halt->time, "stopped", colour::warning});
        else if (const auto& time = exact->passed_horizon())
            plot.marks.push_back({*time, "horizon " + with_unit(*time, 2, "s"), colour_of(*exact)});
    }
    for (const StepNumbers& numbers : base.numbers())
        if (numbers.statistics.impacts > 0) plot.impacts.push_back(numbers.time);
    return plot;
}

Plot energy_plot(const Stage& stage) {
    Plot plot{"Energy", "Energy"};
    for (const Run& run : stage.runs()) {
        Curve& curve = plot.curves.emplace_back(curve_of(run, "J", in_joules, [](const StepNumbers& numbers) {
            return numbers.balls > 0 ? numbers.energy : not_a_number;
        }));
        // Energy is counted from it, so there is a jump.
        for (const GravityChange& change : gravity_changes(run)) {
            const auto after = std::ranges::upper_bound(curve.samples, change.time, {}, &Sample::time);
            curve.samples.insert(after, {change.time, not_a_number});
        }
    }
    for (const auto& [time, gravity] : gravity_changes(stage.lead()))
        plot.marks.push_back({time, gravity == Vec2{} ? "gravity off" : "gravity on", colour::text});
    fit(plot, stage.time() - history_seconds, stage.time());
    return plot;
}

Plot cost_plot(const Stage& stage) {
    const bool per_second = stage.steps_differ();
    Plot plot{per_second ? "CPU time per simulated second" : "CPU time per step", "Cost"};
    for (const Run& run : stage.runs())
        plot.curves.push_back(curve_of(run, "s", in_seconds, [per_second](const StepNumbers& numbers) {
            return per_second ? numbers.cost / numbers.dt : numbers.cost;
        }));
    if (stage.runs().size() == 1) {
        const Run& run = stage.runs().front();
        const auto& stages = run.session().world().statistics().stages;
        for (std::size_t i = 0; i < stages.size() && !stages[i].name.empty(); ++i) {
            Curve curve = curve_of(run, "s", in_seconds, [i](const StepNumbers& numbers) {
                return numbers.timed() ? numbers.statistics.stages[i].seconds : not_a_number;
            });
            curve.name = stages[i].name;
            curve.color = stage_colours[i % std::size(stage_colours)];
            curve.named = true;
            plot.curves.push_back(std::move(curve));
        }
    }
    fit(plot, stage.time() - history_seconds, stage.time());
    return plot;
}

Plot tests_plot(const Stage& stage) {
    Plot plot{"Tests of boxes per step", "Tests"};
    for (const Run& run : stage.runs())
        plot.curves.push_back(curve_of(run, "", in_tests, [](const StepNumbers& numbers) {
            return numbers.statistics.counts_pair_tests ? static_cast<double>(numbers.statistics.pair_tests)
                                                        : not_a_number;
        }));
    fit(plot, stage.time() - history_seconds, stage.time());
    return plot;
}

std::vector<Plot> plots_of(PlotChoice choice, const Stage& stage) {
    const auto with_distance = [&](std::vector<Plot> plots) {
        // Alone nothing is apart.
        if (stage.runs().size() > 1) plots.insert(plots.begin(), distance_plot(stage));
        return plots;
    };
    switch (choice) {
        case PlotChoice::distance_and_energy:
            return with_distance({energy_plot(stage)});
        case PlotChoice::distance_and_cost:
            return with_distance({cost_plot(stage)});
        case PlotChoice::tests_and_cost:
            return {tests_plot(stage), cost_plot(stage)};
        case PlotChoice::all:
            return with_distance({energy_plot(stage), cost_plot(stage), tests_plot(stage)});
        case PlotChoice::distance:
            return stage.runs().size() > 1 ? with_distance({}) : std::vector{energy_plot(stage)};
        case PlotChoice::energy:
            return {energy_plot(stage)};
        case PlotChoice::cost:
            return {cost_plot(stage)};
        case PlotChoice::tests:
            return {tests_plot(stage)};
    }
    return {};
}

}  // namespace flipside::app
