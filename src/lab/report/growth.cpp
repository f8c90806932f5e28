#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/recording.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab::report {

namespace {

const std::vector<Contender>& those_that_grow() {
    static const std::vector<Contender> all{
        {"custom", "custom", "", std::string(colour::custom), 1, 7},
        {"box2d-bullets", "box2d", "bullets=on", std::string(colour::box2d), 1, 5},
        {"box2d-no-bullets", "box2d", "bullets=off", std::string(colour::box2d), 2, 4}};
    return all;
}

std::string file_of(const Contender& contender, int balls) {
    return "growth-" + contender.name + "-" + std::to_string(balls) + ".csv";
}

/// CSV of one row: balls,overlap_99,strays,failure,cpu_ns_per_ball_step. The overlap, in radii, is the one
/// that 1 % of the contacts at the end of steps exceed.
std::string measure(const RunPlan& plan, const Watch& watch) {
    std::vector<double> overlaps;
    Totals totals;
    const std::size_t balls = plan.scene->balls.size();
    const auto after = [&](const Session& session) {
        totals = session.totals();
        const double radius = plan.scene->balls.front().radius;
        for (const Contact& contact : session.world().contacts())
            overlaps.push_back(std::max(0.0, -contact.separation / radius));
    };
    const std::string failure = run_plan(plan, after, watch);
    std::ranges::sort(overlaps, std::greater{});
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double ball_steps = static_cast<double>(balls) * static_cast<double>(totals.steps);
    TextStream file;
    CsvRow row;
    row.add("balls").add("overlap_99").add("strays").add("failure").add("cpu_ns_per_ball_step").write(file);
    row.add(std::uint64_t{balls})
        .add(!failure.empty()   ? infinity
             : overlaps.empty() ? 0
                                : overlaps[overlaps.size() / 100])
        .add(totals.strays)
        .add(failure)
        .add(failure.empty() ? 1e9 * totals.step_seconds / ball_steps : infinity)
        .write(file);
    return file.str();
}

Content show_growth(const Effort& effort, const Data& data) {
    Figure time{"growth-time",
                "Rain: CPU time per ball and step",
                {"balls", "balls", true},
                {"CPU time per ball and step, ns (" + libraries() + ")", "cpu_ns_per_ball_step", true},
                {},
                {},
                "A level curve means that twice the balls take twice the time; the distance between two "
                "curves is how "
                "many times cheaper one engine is. A cross at the upper edge is a run that was given up."};
    Figure overlap{
        "growth-overlap",
        "Rain: what the speed is bought with",
        {"balls", "balls", true},
        {"overlap that 1 % of the contacts exceed, radii", "overlap_99", true, 1e-17},
        {},
        {},
        "Beside every speed its error: the overlap at the end of steps of the same runs. Pointing at a point "
        "says how many balls were lost."};
    for (const Contender& contender : those_that_grow()) {
        Series times = series_of(contender), overlaps = times;
        for (const int balls : effort.growth_balls) {
            const std::string file = file_of(contender, balls);
            const CsvTable table(data.path(file), data.read(file));
            const std::string& failure = table.text(0, "failure");
            const std::string says = failure.empty() ? table.text(0, "strays") + " balls lost" : failure;
            times.points.push_back({table.number(0, "balls"), table.number(0, "cpu_ns_per_ball_step"), says});
            overlaps.points.push_back({table.number(0, "balls"), table.number(0, "overlap_99"), says});
        }
        time.series.push_back(times);
        overlap.series.push_back(overlaps);
    }
    return {{time, overlap}, {}};
}

}  // namespace

Chapter growth_chapter(const Effort& effort) {
    Chapter chapter{"growth",
                    "Cost with the number of balls",
                    "The scene rain at one density, " + short_number(effort.growth_seconds) +
                        " s at 1/60 s a step, with more and more balls. A run that needs more than " +
                        short_number(effort.growth_limit) + " s of CPU time is given up.",
                    {},
                    [effort](const Data& data) { return show_growth(effort, data); }};
    for (const int balls : effort.growth_balls) {
        for (const Contender& contender : those_that_grow()) {
            const auto take = [=](const Watch& watch) {
                const auto rain = std::make_shared<const Scene>(load_scene(scene_file("rain"), balls));
                return measure({rain, contender, effort.growth_seconds, default_step, effort.growth_limit},
                               watch);
            };
            const bool ours = contender.engine == "custom";
            const double guess = effort.growth_seconds * 60 * balls * (ours ? 4e-7 : 4e-6);
            chapter.measurements.push_back(measurement_of_file(
                file_of(contender, balls), 0.01 + std::min(guess, effort.growth_limit), take));
        }
    }
    return chapter;
}

}  // namespace flipside::lab::report
