#include "app/window/editor/editor_report.hpp"

#include "world/json_file.hpp"

namespace flipside::app {

namespace {

const char* role_name(lab::Role role) {
    constexpr const char* names[] = {"corner", "between", "centre", "radius",   "end",      "bulge",
                                     "tip",    "raised",  "pivot",  "velocity", "direction"};
    return names[static_cast<int>(role)];
}

}  // namespace

std::string state_of(const Editor& editor, const Rect& pane, const Camera& camera) {
    const auto pixel = [&](Vec2 in_pane) { return lab::to_pair(in_pane + Vec2{pane.x, pane.y}); };
    lab::OrderedJson j;
    j["name"] = editor.name();
    j["tool"] = editor.tool().name;
    j["unsaved"] = editor.unsaved();
    const lab::Path path = path_of(editor.selected());
    j["selected"] = path;
    j["selection"] = editor.selection().size();
    const lab::OrderedJson* thing = editor.draft().find(editor.selected());
    j["thing"] = thing == nullptr ? lab::OrderedJson() : *thing;
    j["handles"] = lab::OrderedJson::object();
    for (const lab::Handle& handle : editor.handles(camera, 1))
        j["handles"][(handle.member ? "member " + std::to_string(*handle.member) + ' ' : "") +
                     role_name(handle.role) + ' ' + std::to_string(handle.index)] =
            pixel(camera.to_pixels(handle.at));
    if (const auto turn = editor.turn_handle(camera, 1)) j["handles"]["turn"] = pixel(turn->at);
    const Scene& scene = editor.draft().sketch();
    j["parts"] = scene.parts.size();
    j["balls"] = scene.balls.size();
    j["launcher"] = scene.launcher.has_value();
    j["pen"] = editor.pen().size();
    j["pitch"] = editor.pitch;
    const auto& problem = editor.draft().problem();
    j["problem"] = problem ? lab::OrderedJson(problem->words) : lab::OrderedJson();
    return json_text(j);
}

}  // namespace flipside::app
