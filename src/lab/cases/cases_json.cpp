#include <cmath>

#include <nlohmann/json.hpp>

#include "lab/cases/case.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(std::optional<double> number) {
    return number && std::isfinite(*number) ? Json(*number) : Json(nullptr);
}

Json json_of(const CaseRow& row) {
    return {{"quantity", row.quantity},          {"unit", row.unit},
            {"expected", json_of(row.expected)}, {"measured", json_of(row.measured)},
            {"error", json_of(row.error)},       {"tolerance", json_of(row.tolerance)},
            {"interval", json_of(row.interval)}, {"needed", json_of(row.needed)},
            {"verdict", name_of(row.verdict)}};
}

Json json_of(const CaseRun& run) {
    Json rows = Json::array();
    for (const CaseRow& row : run.result.rows) rows.push_back(json_of(row));
    Json recommended = Json::object();
    for (const SettingChange& change : run.recommended) recommended[change.name] = change.value;
    return {{"number", run.which->number},
            {"name", run.which->name},
            {"title", run.which->title},
            {"about", run.which->about},
            {"source", run.which->source},
            {"recommended", recommended},
            {"verdict", name_of(run.result.verdict)},
            {"reason", run.result.reason},
            {"rows", rows},
            {"steps", run.result.steps},
            {"impacts", run.result.impacts},
            {"handed_over", run.result.handed_over},
            {"cpu_seconds", run.result.cpu_seconds}};
}

}  // namespace

std::string to_json(std::span<const CaseRun> runs, const CaseInput& input) {
    Json settings = Json::object(), verdicts = Json::object(), all = Json::array();
    for (const SettingSpec& spec : input.contender.settings.specs())
        settings[std::string(spec.name)] = input.contender.settings.text(spec.name);
    for (const std::string_view name : verdict_names) verdicts[std::string(name)] = 0;
    for (const CaseRun& run : runs) {
        auto& count = verdicts[std::string(name_of(run.result.verdict))];
        count = count.get<int>() + 1;
        all.push_back(json_of(run));
    }
    const Json json{{"format", "flipside-cases/1"},
                    {"engine", input.contender.engine->name},
                    {"settings", settings},
                    {"dt", input.dt},
                    {"quick", input.quick},
                    {"verdicts", verdicts},
                    {"cases", all}};
    return json_text(json, 2) + '\n';
}

}  // namespace flipside::lab
