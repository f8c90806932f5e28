#include "lab/borders/borders.hpp"

#include <algorithm>

#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/contender.hpp"

namespace flipside::lab::report {

namespace {

std::string borders_file(const Contender& contender) {
    return "borders-" + contender.name + ".csv";
}

/// CSV: border,value,failure.
Measurement border_measurement(const Contender& contender, std::size_t most) {
    return measurement_of_file(borders_file(contender), 2, [=](const Watch& watch) {
        const lab::Contender at{&engine_named(contender.engine), settings_of(contender, Scene{})};
        TextStream file;
        CsvRow row;
        row.add("border").add("value").add("failure").write(file);
        for (const BorderPoint& point : find_borders(at, most, watch))
            row.add(point.border).add(point.value).add(point.failure).write(file);
        return file.str();
    });
}

/// How far one contender holds in one experiment.
struct Reach {
    double holds = 0;     ///< 0: nowhere
    double breaks = 0;    ///< 0: nowhere that was tried
    std::string failure;  ///< there
};

Reach reach_of(const CsvTable& table, const Border& border) {
    Reach reach;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "border") != border.name) continue;
        reach.failure = table.text(row, "failure");
        (reach.failure.empty() ? reach.holds : reach.breaks) = table.finite(row, "value");
    }
    return reach;
}

std::string words_of(const Reach& reach) {
    if (reach.breaks == 0) return rounded_text(reach.holds) + " and more";
    return (reach.holds == 0 ? "none" : rounded_text(reach.holds)) + "; at " + rounded_text(reach.breaks) +
           ": " + reach.failure;
}

struct Reaches {
    Contender contender;
    std::vector<Reach> of;  ///< by border
};

std::vector<Reaches> read_reaches(const Data& data) {
    std::vector<Reaches> all;
    for (const Contender& contender : contenders()) {
        const CsvTable table(data.path(borders_file(contender)), data.read(borders_file(contender)));
        all.push_back({contender, {}});
        for (const Border& border : borders()) all.back().of.push_back(reach_of(table, border));
    }
    return all;
}

Figure reach_figure(const std::vector<Reaches>& all) {
    Figure figure{
        "borders",
        "How far each engine holds",
        {"the largest that holds", "value", true},
        {"experiment", "experiment"},
        {},
        {},
        "Each line is an experiment in which one number grows until the engine breaks; further right is "
        "better. Pointing at a mark tells where it breaks and how. A mark at the left edge holds nowhere.",
        true};
    const auto experiments = borders();
    for (const Border& border : experiments) figure.y.things.emplace_back(border.title);
    std::ranges::reverse(figure.y.things);  // the first at the top
    figure.x.floor = 1;
    for (const Reaches& one : all) {
        Series series = series_of(one.contender);
        series.joined = false;
        series.size = 1;
        for (std::size_t i = 0; i < one.of.size(); ++i)
            series.points.push_back({std::max(one.of[i].holds, 1.0), static_cast<double>(one.of.size() - i),
                                     std::string(experiments[i].about) + "\n" +
                                         std::string(experiments[i].title) + ": " + words_of(one.of[i])});
        figure.series.push_back(series);
    }
    return figure;
}

Table reach_table(const std::vector<Reaches>& all) {
    Table table{
        "borders-table",
        "Borders of stability",
        {"What grows", "What happens"},
        {},
        "The largest value tried at which the run holds, and where and how it breaks. \"Refused\" is no "
        "failure: the engine does not do what it cannot do exactly. A run holds when every ball stays in its "
        "box, none overlaps a wall or another by more than a tenth of a radius at the end of any step, none "
        "passes through another, and no energy is gained."};
    for (const Reaches& one : all) table.columns.push_back(one.contender.name);
    const auto experiments = borders();
    for (std::size_t i = 0; i < experiments.size(); ++i) {
        table.rows.push_back({{std::string(experiments[i].title)}, {std::string(experiments[i].about)}});
        for (const Reaches& one : all)
            table.rows.back().push_back({words_of(one.of[i]), false, one.of[i].breaks == 0 ? "good" : ""});
    }
    return table;
}

/// Where each breaks; of each engine's first contender by name.
std::vector<std::string> findings_of(const std::vector<Reaches>& all) {
    std::string text;
    std::vector<std::string> told;
    const auto experiments = borders();
    for (const Reaches& one : all) {
        std::string where;
        std::size_t count = 0;
        bool refused = false;
        for (std::size_t i = 0; i < one.of.size(); ++i) {
            if (one.of[i].breaks == 0) continue;
            ++count;
            refused = refused || one.of[i].failure == "refused";
            where += (where.empty() ? "" : "; ") + std::string(experiments[i].title) + ": " +
                     rounded_text(one.of[i].breaks);
        }
        const bool is_first = std::ranges::find(told, one.contender.engine) == told.end();
        told.push_back(one.contender.engine);
        text += (text.empty() ? "" : ", ") + one.contender.name +
                (refused ? " refuses or breaks in " : " breaks in ") + std::to_string(count);
        if (count > 0 && is_first && !refused) text += " (" + where + ")";
    }
    return {"Of " + std::to_string(experiments.size()) +
            " experiments in which one number grows until the engine breaks " + text + "."};
}

Content show_borders(const Data& data) {
    const auto all = read_reaches(data);
    return {{reach_figure(all)}, {reach_table(all)}, findings_of(all), {}};
}

}  // namespace

Chapter border_chapter(const Effort& effort) {
    Chapter chapter{
        "borders",
        "Borders of stability",
        "Experiments in which one number grows until the engine breaks: a mass ratio, the height of a "
        "stack, a speed, the step. All at 1/60 s a step but the last.",
        {},
        show_borders};
    for (const Contender& contender : contenders())
        chapter.measurements.push_back(border_measurement(contender, effort.most_border_values));
    return chapter;
}

}  // namespace flipside::lab::report
