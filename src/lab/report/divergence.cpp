#include <algorithm>
#include <cmath>
#include <optional>

#include "lab/comparison/parting.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/contender.hpp"
#include "lab/session/run.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::lab::report {

namespace {

/// Past the moment at which the reference no longer claims its positions to this, radii, it is only one more
/// engine.
constexpr double horizon_radii = 1e-3;

struct Duel {
    Contender first, second;
};

/// All against the reference, and one another. The reference says how far it is to be trusted.
std::vector<Duel> duels() {
    auto all = contenders();
    for (Contender& contender : all)
        if (contender.engine == "reference") contender.setting = "twin=on";
    std::vector<Duel> pairs;
    for (auto first = all.rbegin(); first != all.rend(); ++first)
        for (auto second = std::next(first); second != all.rend(); ++second)
            if (first->engine != second->engine) pairs.push_back({*first, *second});
    return pairs;
}

std::string file_of(const Duel& duel) {
    return "divergence-" + duel.first.name + "-" + duel.second.name + ".csv";
}

double claimed_radii(const World& world) {
    double most = 0;
    const auto bounds = world.uncertainty();
    for (std::size_t i = 0; i < bounds.size(); ++i)
        most = std::max(most, bounds[i] / world.balls()[i].radius);
    return most;
}

/// CSV: time,radii,uncertainty,failure. After every step until the balls are not the same any more.
std::string measure(const Duel& duel, double seconds, const Watch& watch) {
    const auto file = scene_file("pinball");
    const auto scene = std::make_shared<const Scene>(load_scene(file));
    const Script script = load_script(*script_beside(file), *scene);
    std::vector<Session> sessions;
    TextStream csv;
    CsvRow row;
    row.add("time").add("radii").add("uncertainty").add("failure").write(csv);
    const auto after = [&](const Session& session, std::uint64_t, double time) {
        watch(time / seconds);
        if (&session == sessions.data()) return;
        const Spread apart = spread(sessions[0].world().balls(), sessions[1].world().balls());
        if (sessions[0].world().balls().empty() || !apart.same_balls) return;
        row.add(time).add(apart.radii).add(claimed_radii(sessions[0].world())).add("").write(csv);
    };
    const auto fail = [&](const std::runtime_error& why) {
        const double time = sessions.empty() ? 0 : sessions[0].world().time();
        row.add(time).add(INFINITY).add(0.0).add(why.what()).write(csv);
    };
    try {
        for (const Contender* contender : {&duel.first, &duel.second})
            sessions.emplace_back(scene, engine_named(contender->engine), settings_of(*contender, *scene));
        run(sessions, Timeline(0, seconds, step_for(*scene)), script, after);
    } catch (const Refusal& refusal) {
        fail(refusal);
    } catch (const NotANumber& failure) {
        fail(failure);
    } catch (const InputError& error) {  // a table that the engine cannot run
        fail(error);
    }
    return csv.str();
}

Series series_of(const Duel& duel, const CsvTable& table) {
    // One look per pair: the second's colour, and where the first is no reference a hollow lozenge.
    Series series = report::series_of(duel.second);
    series.name += " and " + duel.first.name;
    series.size = 0.35;
    if (duel.first.engine != "reference") {
        series.colour = colour::violet;
        series.marker = duel.second.dash == 1 ? 13 : 12;
    }
    constexpr std::size_t samples = 200;
    const std::size_t every = (table.rows() + samples - 1) / samples;
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (row % every == 0 || std::isinf(table.number(row, "radii")))
            series.points.push_back(
                {table.number(row, "time"), table.number(row, "radii"), table.text(row, "failure")});
    return series;
}

std::optional<double> horizon_of(const CsvTable& table) {
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (table.number(row, "uncertainty") > horizon_radii) return table.number(row, "time");
    return std::nullopt;
}

Content show_divergence(const Data& data) {
    Figure figure{
        "divergence",
        "Distance between the same balls on two engines, pinball",
        {"time, s", "time"},
        {"largest distance between the two, radii", "radii", true, 1e-16},
        {},
        {},
        "Every hit multiplies a distance, so a straight rise on this scale is chaos at work and a step is an "
        "impact that fell differently; above 1 the balls have nothing to do with each other any more. "
        "Against "
        "the reference a curve is an error only up to the horizon, the last moment at which the reference "
        "claims its positions to a thousandth of a radius."};
    for (const Duel& duel : duels()) {
        const CsvTable table(data.path(file_of(duel)), data.read(file_of(duel)));
        figure.series.push_back(series_of(duel, table));
        const auto horizon = horizon_of(table);
        if (horizon && figure.marks.empty())
            figure.marks.push_back({*horizon, "past the horizon", std::string(colour::grey), true});
    }
    return {{figure}, {}};
}

}  // namespace

Chapter divergence_chapter(const Effort& effort) {
    Chapter chapter{"divergence",
                    "Divergence",
                    "The pinball table with its script of launches and flips, at " + step_text(default_step) +
                        " a step, on two engines at a time.",
                    {},
                    show_divergence};
    for (const Duel& duel : duels())
        chapter.measurements.push_back(measurement_of_file(file_of(duel), 0.5, [=](const Watch& watch) {
            return measure(duel, effort.divergence_seconds, watch);
        }));
    return chapter;
}

}  // namespace flipside::lab::report
