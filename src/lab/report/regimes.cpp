#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/regimes/measure.hpp"
#include "lab/report/best_settings.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/contender.hpp"
#include "lab/statistics/median.hpp"

namespace flipside::lab::report {

namespace {

using regimes::Course;
using regimes::Kind;
using regimes::Result;

std::vector<Course> courses_of(const Effort& effort) {
    std::vector<Course> all = regimes::courses();
    std::erase_if(all, [&](const Course& course) { return course.balls > effort.most_regime_balls; });
    return all;
}

std::string file_of(std::size_t course) {
    return "regimes-" + std::to_string(course + 1) + ".csv";
}

/// CSV, a row per repeat: regime,balls,contender,failure,cpu_ns,cpu_own_ns,error,deepest,drift,lost.
std::string to_csv(const std::vector<Result>& results) {
    TextStream file;
    CsvRow row;
    for (const char* column : {"regime", "balls", "contender", "failure", "cpu_ns", "cpu_own_ns", "error",
                               "deepest", "drift", "lost"})
        row.add(column);
    row.write(file);
    const double none = std::nan("");
    for (const Result& result : results) {
        const std::vector<double> failed{none};
        for (const double ns : result.failure.empty() ? result.nanoseconds : failed)
            row.add(result.regime)
                .add(std::uint64_t(result.balls))
                .add(result.kind.name)
                .add(result.failure)
                .add(ns)
                .add(result.own)
                .add(result.error.value_or(none))
                .add(result.deepest)
                .add(result.drift.value_or(none))
                .add(std::uint64_t{result.lost})
                .write(file);
    }
    return file.str();
}

Measurement measurement_of(const Course& course, std::size_t index, const Effort& effort) {
    double seconds = 0;
    for (const regimes::Regime& regime : course.regimes)
        seconds += regime.seconds * course.balls * 60 * 2e-5 * effort.regime_repeats;
    return measurement_of_file(file_of(index), seconds, [=](const Watch& watch) {
        const auto all = regimes::kinds();
        return to_csv(measure(course, std::span(all).subspan(course.bare ? 0 : 1),
                              {effort.regime_repeats, true, watch}));
    });
}

/// The results of a course as its file tells them.
std::vector<Result> read_results(const Data& data, const std::string& file, const Course& course) {
    const CsvTable table(data.path(file), data.read(file));
    const auto kinds = regimes::kinds();
    std::vector<Result> results;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto kind = std::ranges::find(kinds, table.text(row, "contender"), &Kind::name);
        const auto regime =
            std::ranges::find(course.regimes, table.text(row, "regime"), &regimes::Regime::name);
        if (kind == kinds.end()) table.refuse(row, "contender", "a contender that is known here");
        if (regime == course.regimes.end()) table.refuse(row, "regime", "a regime of its course");
        if (results.empty() || results.back().kind.name != kind->name ||
            results.back().regime != regime->name) {
            const double error = table.number(row, "error"), drift = table.number(row, "drift");
            results.push_back({regime->name,
                               course.balls,
                               regime->is_kind,
                               *kind,
                               table.text(row, "failure"),
                               {},
                               table.finite(row, "cpu_own_ns"),
                               std::isnan(error) ? std::nullopt : std::optional(error),
                               table.finite(row, "deepest"),
                               std::isnan(drift) ? std::nullopt : std::optional(drift),
                               table.count(row, "lost")});
        }
        if (results.back().failure.empty()) results.back().nanoseconds.push_back(table.finite(row, "cpu_ns"));
    }
    return results;
}

/// All that took part in one regime.
struct Row {
    std::string regime;
    int balls = 0;
    bool is_kind = false;
    std::vector<Result> of;

    [[nodiscard]] std::string name() const { return regime + ", " + std::to_string(balls); }
    [[nodiscard]] std::string with_balls() const { return name() + (balls == 1 ? " ball" : " balls"); }
};

std::vector<Row> rows_of(const std::vector<Course>& courses, const Data& data) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < courses.size(); ++i)
        for (Result& result : read_results(data, file_of(i), courses[i])) {
            if (rows.empty() || rows.back().regime != result.regime || rows.back().balls != result.balls)
                rows.push_back({result.regime, result.balls, result.is_kind, {}});
            rows.back().of.push_back(std::move(result));
        }
    return rows;
}

double cost_of(const Result& result) {
    return median_of(result.nanoseconds).value;
}

/// An engine that reads what happened, and got to the end.
bool counts(const Result& result) {
    return !result.kind.engine.empty() && result.kind.reads && result.failure.empty();
}

bool is_good(const Result& result) {
    return result.deepest <= good_enough && result.error.value_or(0) <= good_enough;
}

/// Null where no engine is allowed.
template <class Allowed>
const Result* cheapest(const Row& row, Allowed allowed) {
    const Result* best = nullptr;
    for (const Result& result : row.of)
        if (counts(result) && allowed(result) && (best == nullptr || cost_of(result) < cost_of(*best)))
            best = &result;
    return best;
}

/// Of their costs, repeat by repeat.
Median ratio_of(const Result& dear, const Result& cheap) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(dear.nanoseconds.size(), cheap.nanoseconds.size()); ++i)
        ratios.push_back(dear.nanoseconds[i] / cheap.nanoseconds[i]);
    return median_of(std::move(ratios));
}

std::string with_interval(const Median& median) {
    return times_text(median.value) + " (" + rounded_text(median.low, 3) + " to " +
           rounded_text(median.high, 3) + ")";
}

/// "0.0088 radii deep" and, where it is known, how far off.
std::string faults_of(const Result& result) {
    return (result.error ? rounded_text(*result.error) + ", " : "") + "overlap " +
           rounded_text(result.deepest) + " radii";
}

Pick pick_of(const Row& row) {
    const std::string kind = row.with_balls();
    const Result* const take = cheapest(row, is_good);
    if (take == nullptr)
        return {kind,
                "nothing",
                std::string(colour::grey),
                "every setting is off or overlaps by more than " + rounded_text(good_enough) + " radii",
                "",
                ""};
    const auto is_other = [&](const Result& result) { return result.kind.engine != take->kind.engine; };
    const Result* other =
        cheapest(row, [&](const Result& result) { return is_other(result) && is_good(result); });
    const std::string none = other == nullptr ? "none is good enough; cheapest is " : "";
    if (other == nullptr) other = cheapest(row, is_other);
    const Median cost = median_of(take->nanoseconds);
    const double within = 100 * std::max(cost.high / cost.value - 1, 1 - cost.low / cost.value);
    const double per_second = 1e-9 * row.balls / regimes::dt;
    return {kind,
            take->kind.name + " at 1/60 s",
            colour_of(take->kind.engine),
            faults_of(*take),
            time_text(cost.value * per_second) + " ± " + rounded_text(within) + " %",
            other == nullptr ? "no other ran it"
                             : none + other->kind.name + " at 1/60 s: " + faults_of(*other) + ", " +
                                   with_interval(ratio_of(*other, *take)) + " the cost"};
}

/// The regimes in which an engine other than `usual` is the cheapest of those allowed, and against what of
/// the usual one.
template <class Allowed>
std::string exceptions(const std::vector<Row>& rows, const std::string& usual, Allowed allowed) {
    std::string text;
    for (const Row& row : rows) {
        const Result* const best = cheapest(row, allowed);
        if (best == nullptr || best->kind.engine == usual) continue;
        const Result* const mine = cheapest(
            row, [&](const Result& result) { return result.kind.engine == usual && is_good(result); });
        text += (text.empty() ? "" : "; ") + row.with_balls() + " (" + best->kind.name;
        if (mine != nullptr)
            text += " at " + with_interval(ratio_of(*best, *mine)) + " the cost, overlap " +
                    rounded_text(best->deepest) + " instead of " + rounded_text(mine->deepest) + " radii";
        text += ")";
    }
    return text;
}

/// The cheapest engine in most of the regimes, and each regime in which another engine is.
std::vector<std::string> findings_of(const std::vector<Row>& rows) {
    std::map<std::string, std::size_t> wins;
    for (const Row& row : rows)
        if (const Result* best = cheapest(row, is_good)) ++wins[best->kind.engine];
    if (wins.empty()) return {};
    const auto usual =
        std::ranges::max_element(wins, {}, &std::pair<const std::string, std::size_t>::second)->first;
    const std::string others = exceptions(rows, usual, is_good);
    const std::string sunk = exceptions(rows, usual, [](const Result&) { return true; });
    return {"By what the balls do: of all that are off and overlap by less than " +
            rounded_text(good_enough) + " radii " + usual + " is the cheapest in " +
            std::to_string(wins.at(usual)) + " of " + std::to_string(rows.size()) + " regimes" +
            (others.empty() ? "." : "; another engine wins " + others + ".") +
            (sunk.empty()
                 ? ""
                 : " Where balls may sink into each other, another engine is cheaper too in " + sunk + ".")};
}

Series series_of(const Kind& kind, std::size_t of_engine) {
    constexpr int markers[] = {7, 6, 9, 8}, squares[] = {5, 4, 11, 10};
    const std::string colour = kind.engine.empty() ? std::string(colour::grey) : colour_of(kind.engine);
    const bool is_first_colour = kind.engine == contenders().front().engine;
    const int marker = (is_first_colour ? markers : squares)[of_engine % 4];
    return {kind.name, colour, 1, marker, 1.0, false, {}, kind.shown};
}

Figure cost_figure(const std::vector<Row>& rows) {
    Figure figure{
        "regimes",
        "Cost by what the balls do",
        {"CPU time per ball and step, ns", "cpu_ns_per_ball_step", true},
        {"regime", "regime"},
        {},
        {},
        "A line for each regime and number of balls, the cheapest at the left: which engine is cheaper "
        "depends on "
        "what the balls do. Pointing at a mark tells its interval, its error and the deepest overlap: a "
        "ball that is let sink into another is cheap.",
        true};
    for (const Row& row : rows) figure.y.things.push_back(row.name());
    std::ranges::reverse(figure.y.things);  // the first at the top
    std::map<std::string, std::size_t> of_engine;
    for (const Kind& kind : regimes::kinds()) {
        Series series = series_of(kind, of_engine[kind.engine]++);
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const Result& result : rows[i].of) {
                if (result.kind.name != kind.name) continue;
                const auto at = static_cast<double>(rows.size() - i);
                if (!result.failure.empty()) continue;
                const Median cost = median_of(result.nanoseconds);
                series.points.push_back({cost.value, at,
                                         rows[i].with_balls() + ": between " + short_number(cost.low) +
                                             " and " + short_number(cost.high) + " ns\n" +
                                             faults_of(result)});
            }
        if (!series.points.empty()) figure.series.push_back(series);
    }
    return figure;
}

Table table_of(const std::vector<Row>& rows) {
    Table table{
        "regimes-table",
        "Regimes: cost, error and overlap",
        {"Regime, balls", "Contender", "Cost, ns per ball and step", "95 % interval", "Its own step, ns",
         "Times the cheapest", "Error, radii", "Deepest overlap, radii", "Change of energy", "Lost"},
        {},
        ""};
    for (const Row& row : rows) {
        const Result* const best = cheapest(row, [](const Result&) { return true; });
        for (const Result& result : row.of) {
            if (!result.failure.empty()) {
                table.rows.push_back({{row.name()},
                                      {result.kind.name},
                                      {result.failure, false, "bad"},
                                      {},
                                      {},
                                      {},
                                      {},
                                      {},
                                      {},
                                      {}});
                continue;
            }
            const Median cost = median_of(result.nanoseconds);
            const auto number = [](std::optional<double> value) {
                return Table::Cell{value ? rounded_text(*value) : "–", true};
            };
            table.rows.push_back({{row.name()},
                                  {result.kind.name},
                                  {rounded_text(cost.value, 3), true},
                                  {rounded_text(cost.low, 3) + " – " + rounded_text(cost.high, 3), true},
                                  {result.own > 0 ? rounded_text(result.own, 3) : "–", true},
                                  {best != nullptr ? rounded_text(ratio_of(result, *best).value) : "–", true,
                                   &result == best ? "good" : ""},
                                  number(result.error),
                                  {result.kind.engine.empty() ? "–" : rounded_text(result.deepest), true,
                                   result.deepest > good_enough ? "bad" : ""},
                                  number(result.drift),
                                  {std::to_string(result.lost), true}});
        }
    }
    return table;
}

}  // namespace

Chapter regime_chapter(const Effort& effort) {
    const auto courses = courses_of(effort);
    const std::string repeats = std::to_string(effort.regime_repeats);
    Chapter chapter{"regimes",
                    "Regimes",
                    "What a step costs depends on what the balls do, so each thing that they do is a row of "
                    "its own: balls that "
                    "fly (gas), fall through a field of segments, hail down onto it, heap up, come to rest "
                    "and sleep, and the "
                    "pinball table. All contenders in one process, a quarter of a simulated second in turn, "
                    "at 1/60 s a step, " +
                        repeats + " runs of each: the median, and its 95 % confidence interval" +
                        (effort.regime_repeats < 6 ? " (of fewer than six runs: their range)." : "."),
                    {},
                    {}};
    for (std::size_t i = 0; i < courses.size(); ++i)
        chapter.measurements.push_back(measurement_of(courses[i], i, effort));
    chapter.show = [courses](const Data& data) {
        const std::vector<Row> rows = rows_of(courses, data);
        Content content{{cost_figure(rows)}, {table_of(rows)}, findings_of(rows), {}};
        content.tables.front().reading =
            "Its own step is the wall time that the engine itself says its step took, without what the "
            "adapter does "
            "to hand over events and contacts; where it tells none there is a dash. Error: the worst ball "
            "against "
            "the reference a tenth of a second after the regime begins, where the reference does not refuse. "
            "The "
            "bare loop is what remains of a toy without events, contacts and continuous collision.";
        for (const Row& row : rows)
            if (row.is_kind) content.picks.push_back(pick_of(row));
        return content;
    };
    return chapter;
}

}  // namespace flipside::lab::report
