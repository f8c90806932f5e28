#include "world/script_file.hpp"

#include <algorithm>

#include "world/schema.hpp"

namespace flipside {

namespace {

constexpr const char* script_format = "flipside-script/1";

Json to_json(const Control& control, const Scene& scene) {
    struct Write {
        const Scene& scene;
        Json operator()(const control::Launch& c) const {
            return {{"control", "launch"}, {"strength", c.strength}, {"count", c.count}, {"size", c.size}};
        }
        Json operator()(const control::Flip& c) const {
            return {{"control", "flip"}, {"side", c.side == Side::left ? "left" : "right"}, {"up", c.up}};
        }
        Json operator()(const control::Nudge& c) const {
            return {{"control", "nudge"}, {"velocity", {c.velocity.x, c.velocity.y}}};
        }
        Json operator()(const control::Rotate& c) const { return {{"control", "rotate"}, {"on", c.on}}; }
        Json operator()(const control::RaiseTargets& c) const {
            Json json = {{"control", "raise_targets"}};
            for (const PartIndex part : c.parts) json["parts"].push_back(scene.parts[part].name);
            return json;
        }
    };
    return std::visit(Write{scene}, control);
}

PartIndex read_target(const Node& node, const Scene& scene) {
    const auto name = node.json().get<std::string>();
    const auto found = std::ranges::find(scene.parts, name, &Part::name);
    if (found == scene.parts.end() || !found->target)
        node.fail(in_quotes(name) + " is no drop target of this scene; allowed: " +
                  names_of(scene.parts, [](const Part& part) { return part.target ? part.name : ""; }));
    return static_cast<PartIndex>(found - scene.parts.begin());
}

Control read_control(const Node& node, const Scene& scene) {
    const std::string kind = node.text("control");
    if (kind == "launch") {
        if (!scene.launcher)
            node.fail("control", "this scene has no launcher; allowed: flip, nudge, rotate, raise_targets");
        return control::Launch{node.real("strength", 1), static_cast<int>(node.integer("count", 1)),
                               node.real("size", 1)};
    }
    if (kind == "flip")
        return control::Flip{node.text("side") == "left" ? Side::left : Side::right, node.toggle("up")};
    if (kind == "nudge") return control::Nudge{node.vector("velocity")};
    if (kind == "rotate") return control::Rotate{node.toggle("on")};
    control::RaiseTargets raise;
    for (const Node& name : node.each("parts")) raise.parts.push_back(read_target(name, scene));
    return raise;
}

}  // namespace

std::string to_json(const Script& script, const Scene& scene) {
    Json controls = Json::array();
    for (const TimedControl& timed : script) {
        Json json = to_json(timed.control, scene);
        json["time"] = timed.time;
        controls.push_back(std::move(json));
    }
    return json_text(Json{{"format", script_format}, {"controls", std::move(controls)}}, 1) + "\n";
}

Script parse_script(std::string_view text, const std::string& file, const Scene& scene) {
    const Json document = parse_json(text, file);
    check_form(document, script_schema, file);
    Script script;
    for (const Node& node : Node(document, file).each("controls")) {
        const double time = node.real("time");
        if (!script.empty() && time < script.back().time)
            node.fail("time", "is before the control above it; allowed: in order of time");
        script.push_back({time, read_control(node, scene)});
    }
    return script;
}

Script load_script(const std::filesystem::path& file, const Scene& scene) {
    return parse_script(read_file(file), file.string(), scene);
}

}  // namespace flipside
