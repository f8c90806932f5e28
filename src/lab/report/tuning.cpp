#include <cmath>
#include <cstdio>

#include "lab/contenders/engines.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/advice.hpp"
#include "lab/report/best_settings.hpp"
#include "lab/report/chapter.hpp"
#include "lab/sweep/windows.hpp"
#include "lab/tune/tune.hpp"

namespace flipside::lab::report {

namespace {

constexpr const char* columns[] = {"variant", "engine", "tried", "role",      "contender",
                                   "error",   "cost",   "ratio", "ratio_low", "ratio_high"};

/// Engines of others, whose settings we may not know how to choose.
std::vector<const Engine*> to_be_tuned() {
    std::vector<const Engine*> all;
    for (const Engine* engine : engines())
        if (!engine->library.empty() || !engine->file.empty()) all.push_back(engine);
    return all;
}

std::string file_of(const sweep::Variant& variant, const Engine& engine) {
    return "tuning-" + variant.name + "-" + std::string(engine.name) + ".csv";
}

/// A row each: the tuned one, the engine as it comes, and our continuous solver; `ratio`: the tuned one's
/// cost over that.
std::string to_csv(const std::vector<tune::Tuning>& all, const Engine& engine) {
    TextStream file;
    CsvRow row;
    for (const char* column : columns) row.add(column);
    row.write(file);
    for (const tune::Tuning& tuning : all) {
        const auto add = [&](const char* role, const tune::Judged& judged,
                             const std::optional<Median>& ratio) {
            const Median shown = ratio.value_or(Median{std::nan(""), std::nan(""), std::nan("")});
            row.add(tuning.variant)
                .add(engine.name)
                .add(std::uint64_t{tuning.tried})
                .add(role)
                .add(judged.text);
            row.add(judged.score.error).add(judged.score.cost);
            row.add(shown.value).add(shown.low).add(shown.high).write(file);
        };
        add("tuned", tuning.tuned, Median{1, 1, 1});
        add("as it comes", tuning.untuned, tuning.over_untuned);
        add("ours, continuous", tuning.ours, tuning.over_ours);
    }
    return file.str();
}

Measurement measurement_of(const sweep::Variant& variant, const Engine& engine, const Effort& effort) {
    return measurement_of_file(file_of(variant, engine), effort.tuning_seconds,
                               [=, &engine](const Watch& watch) {
                                   const tune::Request request{.engine = &engine,
                                                               .targets = {good_enough},
                                                               .windows = effort.tuning_windows,
                                                               .finest = effort.tuning_finest,
                                                               .most_seconds = effort.most_tuning_seconds};
                                   return to_csv(tune::tune(request, variant, watch), engine);
                               });
}

/// The rows of a table, and what they say for the front page.
struct Told {
    Table table;
    std::string reached, missed;
};

void tell(Told& told, const CsvTable& csv) {
    for (std::size_t row = 0; row < csv.rows(); ++row) {
        const double error = csv.number(row, "error"), ratio = csv.number(row, "ratio");
        const std::string kind = kind_of(csv.text(row, "variant"));
        const std::string times =
            std::isnan(ratio) ? "–"
                              : times_text(ratio) + " (" + rounded_text(csv.number(row, "ratio_low")) +
                                    " to " + rounded_text(csv.number(row, "ratio_high")) + ")";
        const double cost = csv.number(row, "cost");
        told.table.rows.push_back({{kind},
                                   {csv.text(row, "engine") + ", " + csv.text(row, "role")},
                                   {csv.text(row, "contender")},
                                   {rounded_text(error), true, error <= good_enough ? "good" : "bad"},
                                   {std::isfinite(cost) ? time_text(cost) : "–", true},
                                   {times, true}});
        if (csv.text(row, "role") != "ours, continuous") continue;
        const bool is_reached = csv.number(row - 2, "error") <= good_enough;
        std::string& list = is_reached ? told.reached : told.missed;
        list += (list.empty() ? "" : "; ") + csv.text(row, "engine");
        list += is_reached ? " costs " + times + " as much on " + kind
                           : " on " + kind + " (" + rounded_text(csv.number(row - 2, "error")) + " radii)";
    }
}

Content show_tuning(const Data& data, const std::vector<sweep::Variant>& variants) {
    Told told{{"tuning",
               "Settings found by search",
               {"Kind of scene", "Who", "Contender", "Error, radii", "Costs a second", "The tuned one costs"},
               {},
               "Each contender is a text for --contender of play, compare and sweep. What a search finds is "
               "a local "
               "optimum; it is judged on windows that the search did not see."},
              "",
              ""};
    for (const sweep::Variant& variant : variants)
        for (const Engine* engine : to_be_tuned())
            if (const std::string file = file_of(variant, *engine); data.has(file))
                tell(told, CsvTable(data.path(file), data.read(file)));
    if (told.table.rows.empty()) return {};
    std::string finding = "Against the cheapest settings that a search finds for an error of at most " +
                          rounded_text(good_enough) + " radii, beside our continuous solver:";
    if (!told.reached.empty()) finding += " " + told.reached + ".";
    if (!told.missed.empty()) finding += " Nothing that was tried gets there: " + told.missed + ".";
    return {{}, {told.table}, {finding}, {}};
}

}  // namespace

Chapter tuning_chapter(const Effort& effort) {
    Chapter chapter{
        "tuning",
        "Tuned settings",
        "An engine that was badly set proves nothing. So for every engine that is not ours all its "
        "settings and its step, down to 1/" +
            std::to_string(effort.tuning_finest) +
            " s, are searched for the cheapest with an error of at most " + rounded_text(good_enough) +
            " radii, scene by scene, on " + std::to_string(effort.tuning_windows) + " windows, for about " +
            rounded_text(effort.most_tuning_seconds) +
            " s of CPU time at most, and judged on as many others (flipside sweep --tune).",
        {},
        [variants = effort.tuned](const Data& data) { return show_tuning(data, variants); }};
    for (const sweep::Variant& variant : effort.tuned)
        for (const Engine* engine : to_be_tuned())
            chapter.measurements.push_back(measurement_of(variant, *engine, effort));
    return chapter;
}

}  // namespace flipside::lab::report
