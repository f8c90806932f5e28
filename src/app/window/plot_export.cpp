#include "app/window/plot_export.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "lab/files/csv.hpp"

namespace flipside::app {

namespace {

constexpr std::string_view header =
    "contender,engine,time_s,cpu_s,stages,energy_j,balls,asleep,box_tests,shape_tests,contacts,impacts,"
    "deepest_overlap_m,distance_radii,distance_from\n";

std::string stages_in_words(const Statistics& statistics) {
    std::ostringstream words;
    words.precision(6);
    for (const StageTime& stage : statistics.stages) {
        if (stage.name.empty()) break;
        words << (words.view().empty() ? "" : "; ") << stage.name << ' ' << stage.seconds;
    }
    return words.str();
}

/// From the reference where it takes part, else from the first.
std::string base_of(const Stage& stage) {
    const Run* exact = stage.exact();
    return (exact ? *exact : stage.runs().front()).name();
}

std::optional<double> distance_at(const Stage& stage, const std::string& name, const std::string& base,
                                  double time) {
    constexpr double same_time = 1e-9;  // s
    for (const Divergence& divergence : stage.divergences()) {
        if (name == base || !divergence.is_of(name) || !divergence.is_of(base)) continue;
        const auto at = std::ranges::lower_bound(divergence.history(), time - same_time, {}, &Sample::time);
        if (at != divergence.history().end() && at->time <= time + same_time) return at->value;
    }
    return std::nullopt;
}

}  // namespace

void write_numbers(std::ostream& out, const Stage& stage) {
    out << header;
    const std::string base = base_of(stage);
    for (const Run& run : stage.runs())
        for (const StepNumbers& numbers : run.numbers()) {
            if (numbers.time > stage.time() + 1e-9) break;
            const Statistics& statistics = numbers.statistics;
            const auto distance = stage.run_named(base).is_measure_at(numbers.time)
                                      ? distance_at(stage, run.name(), base, numbers.time)
                                      : std::nullopt;
            lab::CsvRow row;
            row.add(std::string_view(run.name())).add(run.engine().name).add(numbers.time);
            if (numbers.timed())
                row.add(numbers.cost).add(std::string_view(stages_in_words(statistics)));
            else
                row.add(std::string_view()).add(std::string_view());
            row.add(numbers.energy);
            row.add(std::uint64_t{numbers.balls}).add(statistics.asleep);
            if (statistics.counts_pair_tests)
                row.add(statistics.pair_tests);
            else
                row.add(std::string_view());
            row.add(statistics.narrow_tests).add(statistics.contacts).add(statistics.impacts);
            row.add(numbers.deepest);
            if (distance)
                row.add(*distance).add(std::string_view(base));
            else
                row.add(std::string_view()).add(std::string_view());
            row.write(out);
        }
}

}  // namespace flipside::app
