#include <map>

#include "lab/cases/stability_map.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/contender.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::report {

namespace {

std::string map_file(const Contender& contender) {
    return "stability-" + contender.file + ".csv";
}

Measurement map_measurement(const Contender& contender, const Effort& effort) {
    const auto measure = [contender, steps = effort.map_steps](const Watch& watch) {
        const lab::Contender on_map{&engine_named(contender.engine), settings_of(contender, Scene{})};
        const auto points = stability_map(on_map, steps, watch);
        TextStream file;
        write_stability(file, on_map, points);
        return file.str();
    };
    return measurement_of_file(map_file(contender), 0.5 * static_cast<double>(effort.map_steps.size()),
                               measure);
}

/// One mass ratio and speed, at all steps.
struct Cell {
    std::size_t steps = 0, stable = 0, refused = 0;
    std::string failures;  ///< a line each
};

std::map<std::pair<double, double>, Cell> cells_of(const CsvTable& table) {
    std::map<std::pair<double, double>, Cell> cells;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        Cell& cell = cells[{table.number(row, "mass_ratio"), table.number(row, "speed_radii_per_s")}];
        ++cell.steps;
        const std::string& failure = table.text(row, "failure");
        cell.refused += failure == "refused" ? 1 : 0;
        if (table.count(row, "stable") == 1)
            ++cell.stable;
        else
            cell.failures += "\n" + step_text(table.number(row, "dt")) + ": " + failure;
    }
    return cells;
}

/// The more of the steps hold, the larger the square; where none does, a cross.
Series series_for(const Contender& contender, std::size_t stable, std::size_t steps) {
    if (stable == 0) return {"holds at no step", std::string(colour::warning), 1, 2, 1.2, false, {}};
    const std::string name = stable == steps
                                 ? "holds at every step"
                                 : "at " + std::to_string(stable) + " of " + std::to_string(steps) + " steps";
    const double size = 0.4 + 1.4 * static_cast<double>(stable) / static_cast<double>(steps);
    return {name, contender.colour, 1, stable == steps ? 5 : 4, size, false, {}};
}

Figure figure_of(const Contender& contender, const Data& data) {
    Figure figure{
        "stability-" + contender.file,
        "Stability: " + contender.name,
        {"mass ratio", "mass_ratio", true},
        {"speed of the heavy ball, radii/s", "speed_radii_per_s", true},
        {},
        {},
        "Each mark stands for runs at several steps, from 1/30 s to finer ones: the larger the square, the "
        "more of them hold, "
        "and a full one means all. Pointing at a mark tells at which steps it breaks and how: "
        "energy gained, a ball "
        "out of the box, or balls left in each other. A hollow ring is no failure: the engine "
        "refuses what it cannot do exactly, here a ball pressed between another and the floor."};
    const std::string file = map_file(contender);
    const auto cells = cells_of(CsvTable(data.path(file), data.read(file)));
    if (cells.empty()) throw InputError(data.path(file).string(), "", "has no rows");
    const std::size_t steps = cells.begin()->second.steps;
    const auto add = [&](Series series, auto belongs) {
        for (const auto& [place, cell] : cells)
            if (belongs(cell))
                series.points.push_back({place.first, place.second,
                                         cell.failures.empty() ? "" : "does not hold at" + cell.failures});
        if (!series.points.empty()) figure.series.push_back(series);
    };
    const auto refuses = [=](const Cell& cell) { return cell.refused == steps; };
    for (std::size_t stable = steps + 1; stable-- > 0;)
        add(series_for(contender, stable, steps),
            [&](const Cell& cell) { return cell.stable == stable && !refuses(cell); });
    add({"refused", std::string(colour::grey), 1, 6, 0.8, false, {}}, refuses);
    return figure;
}

Content show_stability(const Data& data) {
    Content content;
    for (const Contender& contender : contenders()) content.figures.push_back(figure_of(contender, data));
    return content;
}

}  // namespace

Chapter stability_chapter(const Effort& effort) {
    Chapter chapter{"stability",
                    "Stability",
                    "A ball lies in a box and a heavier one is thrown down at it, a little off centre, for "
                    "two seconds. A run "
                    "holds when nothing leaves the box, no energy is gained beyond 1 %, and at the end "
                    "nothing overlaps by "
                    "more than a tenth of a radius.",
                    {},
                    show_stability};
    for (const Contender& contender : contenders())
        chapter.measurements.push_back(map_measurement(contender, effort));
    return chapter;
}

}  // namespace flipside::lab::report
