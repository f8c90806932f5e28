#include <cmath>

#include "lab/files/assets.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/recording.hpp"
#include "lab/scenes/elastic_scenes.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab::report {

namespace {

struct EnergyScene {
    std::string id, title;
    std::shared_ptr<const Scene> scene;
};

std::vector<EnergyScene> scenes_of(const Effort& effort) {
    const auto shared = [](Scene scene) { return std::make_shared<const Scene>(std::move(scene)); };
    return {{"gas", "elastic gas of " + std::to_string(effort.gas_balls) + " discs",
             shared(elastic_gas(effort.gas_balls))},
            {"box", "elastic box of 8 discs of different masses", shared(load_scene(scene_file("box")))},
            {"drop", "one ball on an elastic floor", shared(elastic_drop())}};
}

std::string file_of(const EnergyScene& scene, const Contender& contender) {
    return "energy-" + scene.id + "-" + contender.name + ".csv";
}

Measurement measurement_of(const EnergyScene& scene, const Contender& contender, const Effort& effort) {
    const RunPlan plan{scene.scene, contender, effort.energy_seconds};
    const auto measure = [plan](const Watch& watch) {
        double first = 0;
        const auto drift = [&first](const Session& session) {
            const double now = energy(session.world(), session.scene());
            if (session.totals().steps == 0) first = now;
            return (now - first) / std::abs(first);
        };
        return record(plan, drift, watch);
    };
    return measurement_of_file(file_of(scene, contender), scene.id == "gas" ? 2.0 : 0.2, measure);
}

/// The sizes of the drifts; their signs go into the words.
std::vector<Point> sizes_of(std::vector<Point> drifts) {
    for (Point& point : drifts) {
        if (!std::isfinite(point.y)) continue;
        point.says = point.y > 0 ? "gained" : point.y < 0 ? "lost" : "to the last bit as it was";
        point.y = std::abs(point.y);
    }
    return drifts;
}

Figure figure_of(const EnergyScene& scene, const Data& data) {
    Figure figure{
        "energy-" + scene.id,
        "Energy: " + scene.title,
        {"time, s", "time"},
        {"|change of energy| / energy at the start", "energy_change", true, 1e-17},
        {},
        {},
        "Nothing here takes or gives energy, so every curve should lie at the bottom, where doubles round "
        "(about 1e-16). What rises above that is the solver's own doing; pointing at a point says whether "
        "energy was gained or lost."};
    for (const Contender& contender : contenders()) {
        Series series = series_of(contender);
        series.size = 0.4;
        series.points = sizes_of(recorded(data, file_of(scene, contender)));
        figure.series.push_back(series);
    }
    return figure;
}

}  // namespace

Chapter energy_chapter(const Effort& effort) {
    const auto scenes = scenes_of(effort);
    Chapter chapter{
        "energy",
        "Energy",
        "Scenes in which every collision is elastic and nothing rubs, at 1/60 s a step. The total of "
        "kinetic and potential energy is noted about 120 times in a run.",
        {},
        {}};
    for (const EnergyScene& scene : scenes)
        for (const Contender& contender : contenders())
            chapter.measurements.push_back(measurement_of(scene, contender, effort));
    chapter.show = [scenes](const Data& data) {
        Content content;
        for (const EnergyScene& scene : scenes) content.figures.push_back(figure_of(scene, data));
        return content;
    };
    return chapter;
}

}  // namespace flipside::lab::report
