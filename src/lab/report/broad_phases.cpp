#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "custom/broad_phase/registry.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/pairs/pair_tests.hpp"
#include "lab/report/chapter.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::report {

namespace {

constexpr const char* pairs_file = "pairs.csv";

/// Tests are per search in the toy's experiment, per ball and search in the growth; the time, of the growth
/// alone, is per ball and search.
std::string to_csv(const PairTests& found) {
    TextStream file;
    CsvRow row;
    row.add("experiment").add("broad_phase").add("balls").add("tests").add("cpu_ns").write(file);
    for (const PairTests::Row& line : found.rows)
        for (std::size_t i = 0; i < line.tests.size(); ++i)
            row.add("toy")
                .add(line.broad_phase)
                .add(std::uint64_t{PairTests::fewest + i})
                .add(line.tests[i])
                .add(std::nan(""))
                .write(file);
    for (const PairTests::Growth& growth : found.growth)
        for (const auto& cost : growth.costs)
            row.add("growth")
                .add(cost.broad_phase)
                .add(std::uint64_t{growth.balls})
                .add(cost.tests_per_ball)
                .add(cost.ns_per_ball)
                .write(file);
    return file.str();
}

/// Broad phases are no engines: colours and shapes of their own.
constexpr auto titles = [] {
    std::array<std::string_view, std::size(custom::broad_phases)> all{};
    std::ranges::transform(custom::broad_phases, all.begin(), &custom::BroadPhaseKind::title);
    return all;
}();
constexpr std::tuple<std::string_view, int, int> looks[] = {{colour::grey, 1, 4},
                                                            {colour::blue, 1, 7},
                                                            {colour::violet, 2, 9},
                                                            {colour::olive, 1, 5},
                                                            {colour::wine, 4, 13}};
static_assert(std::size(looks) == titles.size());

Series series_named(const std::string& broad_phase) {
    const auto at = std::ranges::find(titles, broad_phase) - titles.begin();
    const auto& [line, dash, marker] = looks[at];
    return {broad_phase, std::string(line), dash, marker, 0.7, true, {}};
}

/// One series per broad phase, in the file's order.
std::vector<Series> series_of(const CsvTable& table, const std::string& experiment, const char* column) {
    std::vector<Series> all;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "experiment") != experiment) continue;
        const std::string& name = table.one_of(row, "broad_phase", titles);
        if (all.empty() || all.back().name != name) {
            const auto at = std::ranges::find(all, name, &Series::name);
            if (at == all.end()) all.push_back(series_named(name));
        }
        std::ranges::find(all, name, &Series::name)
            ->points.push_back({table.number(row, "balls"), table.number(row, column), ""});
    }
    return all;
}

/// The straight line through the points, from the first or where it begins to be above 0, to the last.
Series fit_of(const Series& measured) {
    std::vector<double> x, y;
    for (const Point& point : measured.points) x.push_back(point.x), y.push_back(point.y);
    const LinearFit line = fit_line(x, y);
    const std::string says = short_number(line.slope) + " n " + (line.intercept < 0 ? "− " : "+ ") +
                             short_number(std::abs(line.intercept)) +
                             ", R² = " + short_number(line.r_squared);
    Series fit{measured.name + ": " + short_number(line.slope) + " n", measured.colour, 3, 7, 0.3, true, {}};
    const double begin = std::max(x.front(), -line.intercept / line.slope);  // there are no tests below 0
    for (const double at : {begin, x.back()})
        fit.points.push_back({at, std::max(0.0, line.intercept + line.slope * at), says});
    return fit;
}

Content show_broad_phases(const Data& data) {
    const CsvTable table(data.path(pairs_file), data.read(pairs_file));
    Figure toy{"toy-pairs",
               "Box tests per search in the toy's experiment",
               {"balls n", "balls"},
               {"box tests per search", "tests"},
               series_of(table, "toy", "tests"),
               {},
               ""};
    for (const Series& series : std::vector<Series>(toy.series))
        if (series.name != "brute force") toy.series.push_back(fit_of(series));
    toy.reading =
        "Brute force tests n(n−1)/2 pairs and bends upwards; where another curve crosses it, that broad "
        "phase "
        "begins to pay. The dotted straight lines are fitted through the points: their slope is what one "
        "more "
        "ball costs.";
    const Figure tests{
        "pairs-growth",
        "Box tests per ball, at one density",
        {"balls n", "balls", true},
        {"box tests per ball and search", "tests_per_ball", true},
        series_of(table, "growth", "tests"),
        {},
        "A level curve means that the work grows in proportion to the number of balls. Brute force's rises "
        "like "
        "n itself, and sweep and prune's like its square root, because it sorts along one axis alone."};
    const Figure time{"pairs-time",
                      "CPU time of the search per ball, at one density",
                      {"balls n", "balls", true},
                      {"CPU time per ball and search, ns", "cpu_ns_per_ball", true},
                      series_of(table, "growth", "cpu_ns"),
                      {},
                      "The same searches by the clock, the least of ten. A curve that climbs where its tests "
                      "stay level has "
                      "outgrown the processor's caches."};
    return {{toy, tests, time}, {}};
}

}  // namespace

Chapter broad_phase_chapter(const Effort& effort) {
    const auto measure = [effort](const Watch& watch) {
        return to_csv(count_pair_tests(effort.pair_seconds, effort.most_pair_balls, watch));
    };
    const double growth = 3e-5 * static_cast<double>(effort.most_pair_balls);
    return {"broad-phases",
            "Broad phases",
            "Before shapes are compared, their boxes are: this chapter counts how many box tests each broad "
            "phase "
            "of the custom engine makes, insertion included, to find the pairs whose boxes overlap. The "
            "first figure "
            "repeats the classic toy's experiment with 2 to 32 balls; the others keep its density.",
            {measurement_of_file(pairs_file, 0.1 * effort.pair_seconds + growth, measure)},
            show_broad_phases};
}

}  // namespace flipside::lab::report
