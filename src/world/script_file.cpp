#include "world/script_file.hpp"

#include "world/control_json.hpp"
#include "world/schema.hpp"

namespace flipside {

namespace {

constexpr const char* script_format = "flipside-script/1";

}  // namespace

Json script_document(const Script& script, const Scene& scene) {
    Json controls = Json::array();
    for (const TimedControl& timed : script) {
        Json json = to_json(timed.control, scene, "control");
        json["time"] = timed.time;
        controls.push_back(std::move(json));
    }
    return {{"format", script_format}, {"controls", std::move(controls)}};
}

std::string to_json(const Script& script, const Scene& scene) {
    return json_text(script_document(script, scene), 1) + "\n";
}

Script parse_script(const Node& node, const Scene& scene) {
    check_form(node, script_schema);
    const SceneNames names(scene);
    Script script;
    for (const Node& timed : node.each("controls")) {
        const double time = timed.real("time");
        if (!script.empty() && time < script.back().time)
            timed.fail("time", "is before the control above it; allowed: in order of time");
        script.push_back({time, read_control(timed, names, "control")});
    }
    return script;
}

Script parse_script(std::string_view text, const std::string& file, const Scene& scene) {
    const Json document = parse_json(text, file);
    return parse_script(Node(document, file), scene);
}

Script load_script(const std::filesystem::path& file, const Scene& scene) {
    return parse_script(read_file(file), file.string(), scene);
}

}  // namespace flipside
