#include "lab/sweep/summary.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lab/files/csv.hpp"
#include "lab/files/data_file.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/statistics/median.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::sweep {

namespace fs = std::filesystem;

namespace {

auto place(const Run& run) {
    return std::tie(run.variant, run.contender, run.dt, run.window);
}

/// Largest step first.
bool before(const Run& a, const Run& b) {
    return std::tuple(std::string_view(a.variant), std::string_view(a.contender), -a.dt, a.window) <
           std::tuple(std::string_view(b.variant), std::string_view(b.contender), -b.dt, b.window);
}

/// The smallest value that `share` of the sorted ones do not exceed (nearest rank).
double quantile(const std::vector<double>& sorted, double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::max<std::size_t>(rank, 1) - 1];
}

Figures figures_of(std::span<const Run> runs) {
    Figures figures;
    figures.variant = runs.front().variant;
    figures.contender = runs.front().contender;
    const Contender& contender = contender_named(figures.contender);
    figures.engine = contender.engine;
    figures.settings = contender.settings;
    figures.dt = runs.front().dt;
    figures.windows = runs.size();
    std::vector<double> errors, typical;
    double seconds = 0;
    for (const Run& run : runs) {
        const Outcome& outcome = run.outcome;
        errors.push_back(outcome.error);
        typical.push_back(outcome.typical);
        figures.exact += outcome.error <= exact_radii ? 1U : 0U;
        if (!outcome.failure.empty()) ++figures.failed, ++figures.failures[outcome.failure];
        figures.impacts += outcome.impacts;
        figures.missed += outcome.missed;
        figures.spurious += outcome.spurious;
        if (const auto& blame = run.blame) ++figures.blame[{blame->fault, blame->kind, blame->met}];
        if (std::isnan(run.cpu_min)) continue;
        ++figures.timed;
        seconds += run.seconds;
        figures.costs[run.window] = run.cpu_min / run.seconds;
        figures.cpu_min += run.cpu_min;
        figures.cpu_median += run.cpu_median;
    }
    std::ranges::sort(errors);
    std::ranges::sort(typical);
    figures.median = quantile(errors, 0.5);
    const Median sure = median_of(errors);
    figures.median_low = sure.low, figures.median_high = sure.high;
    figures.p95 = quantile(errors, 0.95);
    figures.max = errors.back();
    figures.typical_median = quantile(typical, 0.5);
    figures.typical_p95 = quantile(typical, 0.95);
    figures.cpu_min = seconds > 0 ? figures.cpu_min / seconds : std::nan("");
    figures.cpu_median = seconds > 0 ? figures.cpu_median / seconds : std::nan("");
    return figures;
}

std::string text_of(const std::map<std::string, std::size_t>& failures) {
    std::string text;
    for (const auto& [name, count] : failures)
        text += (text.empty() ? "" : "; ") + std::to_string(count) + ' ' + name;
    return text;
}

/// The text of the plan that all folders have.
std::string common_plan(std::span<const fs::path> folders) {
    std::string first;
    for (const fs::path& folder : folders) {
        const std::string plan = read_plan(folder);
        if (first.empty()) first = plan;
        if (plan != first)
            throw InputError((folder / "plan.json").string(), "",
                             "differs from that of " + folders.front().string() +
                                 "; allowed are folders of one and the same sweep");
    }
    return first;
}

}  // namespace

std::vector<Run> gather(std::span<const fs::path> folders) {
    const std::string text = common_plan(folders);
    const Plan plan = parse_plan(text, (folders.front() / "plan.json").string());
    std::vector<Run> all;
    for (const fs::path& folder : folders) {
        bool has_runs = false;
        for (const Unit& unit : units_of(plan)) {
            const fs::path file = runs_file(unit, folder);
            if (!is_there(file)) continue;
            has_runs = true;
            std::ranges::move(
                parse_runs(read_data_file(file, origin_of_unit("runs", text, unit)), file, plan, unit),
                std::back_inserter(all));
        }
        if (!has_runs) throw InputError(folder.string(), "", "holds no runs of its sweep");
    }
    std::ranges::stable_sort(all, before);
    const auto same = [](const Run& a, const Run& b) { return place(a) == place(b); };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
}

std::vector<Figures> summarize(std::span<const Run> runs) {
    std::vector<Figures> all;
    for (auto begin = runs.begin(); begin != runs.end();) {
        const auto key = [](const Run& run) { return std::tie(run.variant, run.contender, run.dt); };
        const auto end =
            std::find_if(begin, runs.end(), [&](const Run& run) { return key(run) != key(*begin); });
        all.push_back(figures_of({begin, end}));
        begin = end;
    }
    return all;
}

void write_summary(const fs::path& file, std::span<const Figures> all) {
    WholeFile whole(file);
    whole.out() << "variant,contender,engine,settings,dt,windows,failed,failures,median,median_low,median_"
                   "high,p95,max,"
                   "typical_median,typical_p95,exact,impacts,missed,spurious,timed,cpu_min,cpu_median\n";
    CsvRow row;
    for (const Figures& f : all) {
        row.add(f.variant).add(f.contender).add(f.engine).add(f.settings).add(f.dt).add(f.windows);
        row.add(f.failed).add(text_of(f.failures)).add(f.median);
        row.add(f.median_low).add(f.median_high).add(f.p95).add(f.max);
        row.add(f.typical_median)
            .add(f.typical_p95)
            .add(f.exact)
            .add(f.impacts)
            .add(f.missed)
            .add(f.spurious);
        row.add(f.timed).add(f.cpu_min).add(f.cpu_median).write(whole.out());
    }
    whole.finish();
}

}  // namespace flipside::lab::sweep
