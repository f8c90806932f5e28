#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/files/assets.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/recording.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab::report {

namespace {

/// Shares of the contacts, as many of which lie deeper.
constexpr double shares[] = {0.9,  0.7,   0.5,   0.3,   0.2,    0.1,    0.05,  0.02,
                             0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002, 0.0001};

std::string overlaps_file(const Contender& contender) {
    return "penetration-" + contender.name + ".csv";
}

/// CSV: share,depth,contacts,failure. Depth in radii; the last row is the deepest of all.
std::string to_csv(std::vector<double> depths, const std::string& failure) {
    std::ranges::sort(depths, std::greater{});
    TextStream file;
    CsvRow row;
    row.add("share").add("depth").add("contacts").add("failure").write(file);
    const auto count = static_cast<double>(depths.size());
    for (const double share : shares)
        if (share * count >= 1)
            row.add(share)
                .add(depths[static_cast<std::size_t>(share * count)])
                .add(std::uint64_t{depths.size()})
                .add("")
                .write(file);
    if (!depths.empty())
        row.add(1 / count).add(depths.front()).add(std::uint64_t{depths.size()}).add("").write(file);
    if (!failure.empty())
        row.add(1.0)
            .add(std::numeric_limits<double>::infinity())
            .add(std::uint64_t{depths.size()})
            .add(failure)
            .write(file);
    return file.str();
}

Measurement overlaps_measurement(const RunPlan& plan) {
    const auto measure = [plan](const Watch& watch) {
        std::vector<double> depths;
        const auto after = [&](const Session& session) {
            const double radius = session.scene().balls.front().radius;
            for (const Contact& contact : session.world().contacts())
                depths.push_back(std::max(0.0, -contact.separation / radius));
        };
        const std::string failure = run_plan(plan, after, watch);
        return to_csv(depths, failure);
    };
    return measurement_of_file(overlaps_file(plan.contender), 4, measure);
}

Content show_penetration(const Data& data) {
    Figure figure{
        "penetration",
        "Overlap in rain",
        {"share of the contacts that overlap more", "share", true},
        {"overlap, radii", "depth", true, 1e-17},
        {},
        {},
        "Read a curve from right to left: at 0.5 stands the overlap of the median contact, at 0.01 the one "
        "that 1 % of the contacts exceed, and its left end is the deepest of all. Lower is better; a ball "
        "that overlaps by more than a radius has its centre on the wrong side. A cross at the upper edge is "
        "a run that its engine refused to go on with; pointing at it tells why."};
    for (const Contender& contender : contenders()) {
        const CsvTable table(data.path(overlaps_file(contender)), data.read(overlaps_file(contender)));
        Series series = series_of(contender);
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const std::string& failure = table.text(row, "failure");
            series.points.push_back(
                {table.number(row, "share"), table.number(row, "depth"),
                 failure.empty() ? "of " + table.text(row, "contacts") + " contacts" : failure});
        }
        figure.series.push_back(series);
    }
    return {{figure}, {}};
}

}  // namespace

Chapter penetration_chapter(const Effort& effort) {
    const auto rain = std::make_shared<const Scene>(load_scene(scene_file("rain"), effort.rain_balls));
    Chapter chapter{
        "penetration",
        "Penetration",
        std::to_string(effort.rain_balls) + " balls of the scene rain for " +
            short_number(effort.rain_seconds) +
            " s at 1/60 s a step. After every step each contact is asked how deep its two shapes lie in "
            "each other.",
        {},
        show_penetration};
    for (const Contender& contender : contenders())
        chapter.measurements.push_back(overlaps_measurement({rain, contender, effort.rain_seconds}));
    return chapter;
}

}  // namespace flipside::lab::report
