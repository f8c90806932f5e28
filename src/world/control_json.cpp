#include "world/control_json.hpp"

namespace flipside {

namespace {

PartIndex read_target(const Node& node, const SceneNames& names) {
    const auto& name = node.json().get_ref<const std::string&>();
    const auto& parts = names.scene().parts;
    const auto found = names.part(name);
    if (!found || !parts[*found].target)
        node.fail(in_quotes(name) + " is no drop target of this scene; allowed: " +
                  names_of(parts, [](const Part& part) { return part.target ? part.name : ""; }));
    return *found;
}

}  // namespace

Json to_json(const Control& control, const Scene& scene, const char* key) {
    struct Write {
        const Scene& scene;
        const char* key;
        Json operator()(const control::Launch& c) const {
            return {{key, "launch"}, {"strength", c.strength}, {"count", c.count}, {"size", c.size}};
        }
        Json operator()(const control::Flip& c) const {
            return {{key, "flip"}, {"side", c.side == Side::left ? "left" : "right"}, {"up", c.up}};
        }
        Json operator()(const control::Nudge& c) const {
            return {{key, "nudge"}, {"velocity", {c.velocity.x, c.velocity.y}}};
        }
        Json operator()(const control::Rotate& c) const { return {{key, "rotate"}, {"on", c.on}}; }
        Json operator()(const control::RaiseTargets& c) const {
            Json json = {{key, "raise_targets"}};
            for (const PartIndex part : c.parts) json["parts"].push_back(scene.parts[part].name);
            return json;
        }
    };
    return std::visit(Write{scene, key}, control);
}

Control read_control(const Node& node, const SceneNames& names, const char* key) {
    const std::string kind = node.text(key);
    if (kind == "launch") {
        if (!names.scene().launcher)
            node.fail(key, "this scene has no launcher; allowed: flip, nudge, rotate, raise_targets");
        return control::Launch{node.real("strength", 1), static_cast<int>(node.integer("count", 1)),
                               node.real("size", 1)};
    }
    if (kind == "flip")
        return control::Flip{node.text("side") == "left" ? Side::left : Side::right, node.toggle("up")};
    if (kind == "nudge") return control::Nudge{node.vector("velocity")};
    if (kind == "rotate") return control::Rotate{node.toggle("on")};
    control::RaiseTargets raise;
    for (const Node& name : node.each("parts")) raise.parts.push_back(read_target(name, names));
    return raise;
}

}  // namespace flipside
