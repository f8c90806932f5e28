#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "lab/contenders/engines.hpp"
#include "lab/pairs/pair_tests.hpp"
#include "lab/report/advice.hpp"
#include "lab/report/best_settings.hpp"
#include "lab/report/blame_tables.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/contender.hpp"
#include "lab/sweep/blame_counts.hpp"
#include "lab/sweep/sweep.hpp"

namespace flipside::lab::report {

namespace {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double floor_radii = 1e-16;

/// The engine's colour; dashes and shapes tell its contenders apart.
Series series_of(const sweep::Figures& first, std::size_t of_engine) {
    constexpr int markers[] = {7, 6, 9, 8, 13, 12}, squares[] = {5, 4, 11, 10, 13, 12};
    const bool is_box2d = first.engine == "box2d";
    const std::size_t look = of_engine % std::size(markers);
    const int dash = 1 + static_cast<int>(of_engine % 5);
    return {first.contender,
            colour_of(first.engine),
            dash,
            is_box2d ? squares[look] : markers[look],
            0.8,
            true,
            {}};
}

std::string words_of(const sweep::Figures& f) {
    std::string words = "dt = " + step_text(f.dt) + (f.settings.empty() ? "" : ", " + f.settings);
    words += "\nof " + std::to_string(f.windows) + " windows: median between " + short_number(f.median_low) +
             " and " + short_number(f.median_high) + " radii (95 % sure), 95 % of them within " +
             short_number(f.p95) + "; median ball " + short_number(f.typical_median) + " radii";
    words += "\n" + std::to_string(f.missed) + " of " + std::to_string(f.impacts) + " impacts missed, " +
             std::to_string(f.spurious) + " too many";
    for (const auto& [name, count] : f.failures) words += "\n" + std::to_string(count) + " failed: " + name;
    return words;
}

/// One series per contender, in the order of the summary; what x is of a setting is the caller's.
template <class X>
std::vector<Series> curves(const std::vector<sweep::Figures>& all, std::span<const Best> best,
                           const std::string& variant, X x_of) {
    std::vector<Series> series;
    std::map<std::string, std::size_t> of_engine;
    for (const sweep::Figures& f : all) {
        if (f.variant != variant) continue;
        if (series.empty() || series.back().name != f.contender)
            series.push_back(series_of(f, of_engine[f.engine]++)), series.back().shown = is_telling(f, best);
        series.back().points.push_back({x_of(f), f.median, words_of(f)});
    }
    return series;
}

Figure work_figure(const std::vector<sweep::Figures>& all, std::span<const Best> best,
                   const std::string& variant) {
    // What was not timed is no cheap run: it goes to the right edge.
    const auto cost = [](const sweep::Figures& f) { return std::isnan(f.cpu_min) ? infinity : f.cpu_min; };
    return {"work-" + variant,
            "Error against cost: " + kind_of(variant),
            {"CPU seconds per simulated second (" + libraries() + ")", "cpu_seconds_per_second", true},
            {"median error at the end of a window, radii", "median_error", true, floor_radii},
            curves(all, best, variant, cost),
            {},
            "Each point is one setting; further down is more exact, further left is cheaper, so of two "
            "curves the lower left one is better. A cross at the upper edge is a setting at which half of "
            "the windows or more "
            "failed."};
}

/// Below this a straight line says nothing of how the error falls.
constexpr double least_r_squared = 0.95;

/// A straight line through the logarithms of those errors that are above what rounding leaves. Without points
/// where the errors do not lie on one.
Series fitted_order(const Series& measured) {
    constexpr double rounding = 1e-12;
    std::vector<double> x, y;
    for (const Point& point : measured.points)
        if (std::isfinite(point.y) && point.y > rounding)
            x.push_back(std::log10(point.x)), y.push_back(std::log10(point.y));
    Series fit{measured.name, measured.colour, 3, measured.marker, 0.3, true, {}, measured.shown};
    if (x.size() < 3) return fit;
    const LinearFit line = fit_line(x, y);
    if (line.r_squared < least_r_squared) return fit;
    char order[48];
    std::snprintf(order, sizeof order, "%.2f (R² %.3f)", line.slope, line.r_squared);
    fit.name += std::string(": order ") + order;
    for (const double at : {*std::ranges::max_element(x), *std::ranges::min_element(x)})
        fit.points.push_back({std::pow(10, at), std::pow(10, line.intercept + line.slope * at),
                              "fitted to " + std::to_string(x.size()) + " steps: order " + order});
    return fit;
}

Figure order_figure(const std::vector<sweep::Figures>& all, std::span<const Best> best,
                    const std::string& variant) {
    Figure figure{"order-" + variant,
                  "Error against step: " + kind_of(variant),
                  {"step dt, s", "dt", true},
                  {"median error at the end of a window, radii", "median_error", true, floor_radii},
                  curves(all, best, variant, [](const sweep::Figures& f) { return f.dt; }),
                  {},
                  "A solver of order p has an error that falls with dt to the power p, a straight line of "
                  "that slope: the dotted lines are fitted, and the key gives their slopes and how well they "
                  "fit. A solver without a dotted line has an error that does not depend on the step, or not "
                  "by a power of it (R² below 0.95)."};
    for (const Series& measured : std::vector<Series>(figure.series)) {
        Series fit = fitted_order(measured);
        if (!fit.points.empty()) figure.series.push_back(std::move(fit));
    }
    return figure;
}

Content content_of(const std::vector<sweep::Figures>& all) {
    const std::vector<Best> best = best_settings(all);
    Content content{{}, blame_tables(all, best), findings_of(all, best), {}};
    for (const Best& one : best) {
        content.picks.push_back(pick_of(all, one));
        content.figures.push_back(work_figure(all, best, one.variant));
        content.figures.push_back(order_figure(all, best, one.variant));
    }
    content.figures.front().on_front = true;
    return content;
}

}  // namespace

Chapter work_precision_chapter(const Effort& effort, const std::vector<fs::path>& from) {
    Chapter chapter{
        "work-precision",
        "Work and precision",
        "Many states along trajectories of the exact reference are the starts of short windows, each with at "
        "least one hit. Every engine runs every window at steps of 1/30 s and finer; its error is the "
        "distance "
        "between its worst ball and the exact place at the end. The cost is the least CPU time of several "
        "repetitions, all engines in turn. The tables say which decision of an engine its errors begin with.",
        {},
        {}};
    if (!from.empty()) {
        // Read at once: what is wrong with it shall not come out after all measurements.
        chapter.show = [all = sweep::summarize(sweep::gather(from))](const Data&) { return content_of(all); };
        return chapter;
    }
    const sweep::Plan plan =
        effort.quick_sweep ? sweep::quick_plan(effort.variants, 1) : sweep::Plan{.variants = effort.variants};
    const auto take = [plan](const Data& data, const Watch& watch) {
        sweep::make_runs(plan, {}, data.folder(), watch, data.notice());
        const auto figures = sweep::summarize(sweep::gather({&data.folder(), 1}));
        sweep::write_summary(data.path("sweep.csv"), figures);
        sweep::write_blame(data.path("blame.csv"), figures);
    };
    // A sweep looks itself at which of its files are there.
    const auto never = [](const Data&) { return false; };
    chapter.measurements.push_back({effort.sweep_seconds, never, take});
    chapter.show = [](const Data& data) {
        return content_of(sweep::summarize(sweep::gather({&data.folder(), 1})));
    };
    return chapter;
}

}  // namespace flipside::lab::report
