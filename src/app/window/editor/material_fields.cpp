#include "app/window/editor/material_fields.hpp"

#include <algorithm>

#include "app/window/panel_parts.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

constexpr const char* no_material = "none: e 1, µ 0";

/// How many balls and parts are of it.
std::size_t users_of(const Scene& scene, const std::string& name) {
    const auto of_it = [&](const auto& thing) { return scene.materials[thing.material].name == name; };
    return static_cast<std::size_t>(std::ranges::count_if(scene.parts, of_it) +
                                    std::ranges::count_if(scene.balls, of_it));
}

void material_chooser(Editor& editor, const FieldSet& fields, ControlPlaces& places, const lab::Path& thing,
                      const std::string& now) {
    label("Material", "What it is made of");
    const std::string shown = now.empty() ? no_material : printable(now);
    if (ImGui::BeginCombo("##material", shown.c_str())) {
        if (ImGui::Selectable(no_material, now.empty()) && !now.empty()) {
            lab::OrderedJson without = *fields.find(thing);
            without.erase("material");
            editor.draft().set(thing, without);
            editor.draft().end_step();
        }
        const std::vector<Material> materials = editor.draft().sketch().materials;
        for (std::size_t i = 1; i < materials.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(printable(materials[i].name).c_str(), materials[i].name == now)) {
                editor.draft().set(thing / "material", materials[i].name);
                editor.draft().end_step();
            }
            ImGui::PopID();
            note(places, "material " + materials[i].name);
        }
        ImGui::EndCombo();
    }
    note(places, "Material");
}

}  // namespace

void material_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places, const lab::Path& thing) {
    const lab::OrderedJson* named = fields.find(thing / "material");
    const std::string now = named == nullptr ? "" : named->get<std::string>();
    material_chooser(editor, fields, places, thing, now);
    named = fields.find(thing / "material");
    if (named != nullptr) {
        const lab::Path material{"materials", named->get<std::string>()};
        fields.number(
            material / "restitution",
            {"Restitution", "Speed after a hit over speed before; of two materials the product counts", "", 1,
             0, 1000, 1});
        fields.number(
            material / "friction",
            {"Friction", "Coefficient µ; of two materials the geometric mean counts", "", 1, 0, 1000});
        fields.number(material / "kick", {"Kick", "Least speed away after a hit, m/s", "m/s", 1, 0, 1e6});
        const std::size_t users = users_of(editor.draft().sketch(), material.back());
        ImGui::TextDisabled("Used by %zu", users);
        ImGui::SameLine();
    }
    if (ImGui::SmallButton("New material")) {
        editor.draft().end_step();
        editor.draft().add_material(thing, now);
        editor.draft().end_step();
    }
    tooltip("A copy of it for this thing alone");
    note(places, "New material");
}

void layer_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places, const lab::Path& thing) {
    const lab::OrderedJson* layer = fields.find(thing / "layer");
    std::string name = layer == nullptr ? "default" : layer->get<std::string>();
    if (fields.typed_text("Layer", "Things meet where each is in a layer that the other meets", name, 100) &&
        !name.empty())
        editor.draft().set(thing / "layer", name);
    const std::vector<std::string>& layers = editor.draft().scene()->layers;
    const auto met = [&](const std::string& other) {
        const lab::OrderedJson* meets = fields.find(thing / "collides_with");
        return meets == nullptr ||
               std::ranges::any_of(*meets, [&](const lab::OrderedJson& one) { return one == other; });
    };
    for (const std::string& other : layers) {
        bool on = met(other);
        if (ImGui::Checkbox(("meets " + printable(other)).c_str(), &on)) {
            lab::OrderedJson list = lab::OrderedJson::array();
            for (const std::string& one : layers)
                if (one == other ? on : met(one)) list.push_back(one);
            editor.draft().set(thing / "collides_with", list);
            editor.draft().end_step();
        }
        note(places, "meets " + other);
    }
}

}  // namespace flipside::app
