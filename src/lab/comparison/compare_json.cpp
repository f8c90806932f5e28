#include <cmath>

#include <nlohmann/json.hpp>

#include "lab/comparison/compare.hpp"
#include "lab/files/csv.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(Vec2 v) {
    return Json::array({v.x, v.y});
}

Json json_of(const std::optional<Event>& impact, const Scene& scene) {
    if (!impact) return nullptr;
    return {{"time", impact->time},
            {"ball", impact->ball},
            {"other", name_of_other(*impact, scene)},
            {"point", json_of(impact->point)},
            {"normal", json_of(impact->normal)},
            {"speed", impact->speed}};
}

/// A number, or nothing where it is infinite, which JSON has not.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json json_of(const std::optional<RunBlame>& found, const Scene& scene) {
    if (!found) return nullptr;
    Json json{{"until", found->until}, {"why", found->why}, {"divergence", nullptr}};
    if (!found->blame) return json;
    const Blame& blame = *found->blame;
    Json met = nullptr;
    if (blame.other) {
        Event event;
        event.other = *blame.other;
        met = name_of_other(event, scene);
    }
    json["divergence"] = {{"ball", found->ball},
                          {"radii", finite(found->radii)},
                          {"fault", name_of(blame.fault)},
                          {"stage", stage_of(blame.fault)},
                          {"kind", blame.kind},
                          {"met", met},
                          {"of_ball", blame.ball},
                          {"time", blame.time},
                          {"amount", blame.amount},
                          {"says", in_words(blame, scene)}};
    return json;
}

Json json_of(const EngineRun& run, const Scene& scene) {
    Json settings = Json::object();
    for (const SettingSpec& spec : run.contender.settings.specs())
        settings[std::string(spec.name)] = run.contender.settings.text(spec.name);
    const RunFigures& figures = run.figures;
    Json json{{"name", run.contender.name},
              {"engine", run.contender.engine->name},
              {"dt", run.contender.dt},
              {"settings", settings}};
    json.update(Json::parse(to_json(figures)));
    const Totals& totals = figures.totals;
    json["cpu_seconds_per_step"] = totals.steps > 0 ? totals.step_seconds / double(totals.steps) : 0.0;
    json["cpu_seconds_per_sim_second"] =
        figures.sim_seconds > 0 ? totals.step_seconds / figures.sim_seconds : 0.0;
    json["energy_drift"] = figures.energy_last - figures.energy_first;
    json["ended"] = run.ended ? Json{{"time", run.ended->time}, {"why", run.ended->why}} : Json();
    json["blame"] = json_of(run.blame, scene);
    return json;
}

Json json_of(const std::optional<Parting>& parting, const Scene& scene, const Json& names) {
    if (!parting) return nullptr;
    return {{"time", parting->time},
            {"ball", parting->ball},
            {"index", parting->index},
            {names[0], json_of(parting->first, scene)},
            {names[1], json_of(parting->second, scene)}};
}

Json json_of(const std::optional<Pair::Parted>& parted, const Scene& scene) {
    if (!parted) return nullptr;
    return {{"time", parted->time},
            {"ball", parted->spread.ball},
            {"radii", parted->spread.radii},
            {"same_balls", parted->spread.same_balls},
            {"last_impact", json_of(parted->after, scene)}};
}

Json json_of(const Pair& pair, const Comparison& comparison) {
    const Scene& scene = *comparison.input.scene;
    const Json names{comparison.runs.front().contender.name, comparison.runs[pair.second].contender.name};
    Json by_ball = Json::object();
    for (const auto& [ball, count] : pair.match.matched) by_ball[std::to_string(ball)] = count;
    return {{"engines", names},
            {"contacts_matched", pair.match.total},
            {"contacts_matched_before_parting", pair.match.before_parting},
            {"contacts_matched_by_ball", by_ball},
            {"contacts_in_same_order", pair.match.in_order},
            {"first_parting", json_of(pair.match.parting, scene, names)},
            {"first_radius_apart", json_of(pair.parted, scene)},
            {"radii_apart_at_end", pair.at_end.radii},
            {"radii_apart", pair.radii}};
}

}  // namespace

std::string to_json(const Comparison& comparison) {
    Json engines = Json::array(), pairs = Json::array();
    for (const EngineRun& run : comparison.runs) engines.push_back(json_of(run, *comparison.input.scene));
    for (const Pair& pair : comparison.pairs) pairs.push_back(json_of(pair, comparison));
    const Json json{{"scene", comparison.input.scene->name},
                    {"seconds", comparison.input.seconds},
                    {"dt", comparison.dt},
                    {"engines", engines},
                    {"pairs", pairs},
                    {"times", comparison.times}};
    return json_text(json, 2) + '\n';
}

}  // namespace flipside::lab
