#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/contender_choice.hpp"
#include "app/window/contender_colour.hpp"
#include "app/window/panel_tabs.hpp"
#include "app/window/words.hpp"
#include "world/input_error.hpp"

namespace flipside::app {

namespace {

/// "motion_iterations" as people write it.
std::string in_words(std::string_view name) {
    return sentence(with_spaces(name));
}

/// A wide range in powers of ten.
ImGuiSliderFlags spread(const SettingSpec& spec) {
    const bool wide = spec.min > 0 && spec.max / spec.min > 100;
    return wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
}

/// A choice, slider or check box for one setting; true when the user changed `value`.
bool edit(const SettingSpec& spec, const Settings& settings, double& value) {
    switch (spec.type) {
        case SettingType::toggle: {
            bool on = settings.toggle(spec.name);
            const bool changed = ImGui::Checkbox("##value", &on);
            value = on ? 1 : 0;
            return changed;
        }
        case SettingType::choice: {
            const std::string current(settings.choice(spec.name));
            bool changed = false;
            if (ImGui::BeginCombo("##value", current.c_str())) {
                for (std::size_t i = 0; i < spec.choices.size(); ++i)
                    if (ImGui::Selectable(std::string(spec.choices[i]).c_str(), spec.choices[i] == current)) {
                        value = static_cast<double>(i);
                        changed = true;
                    }
                ImGui::EndCombo();
            }
            return changed;
        }
        case SettingType::integer: {
            int number = settings.integer(spec.name);
            const bool changed = slider("##value", number, static_cast<int>(spec.min),
                                        static_cast<int>(spec.max), spread(spec));
            value = number;
            return changed;
        }
        case SettingType::real:
            break;
    }
    value = settings.real(spec.name);
    // Small lengths and times read best with a prefix; the words then stand for the number itself.
    const bool small = (spec.unit == "m" || spec.unit == "s") && std::abs(value) < 0.1;
    const std::string unit(spec.unit);
    const std::string format = small ? engineering(value, unit) : "%.4g " + unit;
    return slider("##value", value, spec.min, spec.max, format.c_str(),
                  spread(spec) | ImGuiSliderFlags_NoRoundToFormat);
}

/// One line. What changes nothing at present is greyed and says why.
void draw_setting(const Panel& panel, std::size_t index, const SettingSpec& spec) {
    const Run& run = panel.stage.runs()[index];
    const Settings& settings = run.session().settings();
    const std::string unit = spec.unit.empty() ? "" : " (" + std::string(spec.unit) + ")";
    const std::string idle = settings.idle(spec.name);
    const std::string meaning =
        (idle.empty() ? "" : "Changes nothing now: " + idle + ".\n") + sentence(spec.about) + unit;
    ImGui::PushID(spec.name.data(), spec.name.data() + spec.name.size());
    ImGui::BeginDisabled(!idle.empty());
    label(in_words(spec.name), meaning);
    double value = 0;
    const bool changed = edit(spec, settings, value);
    note(panel.places, run.name() + "." + std::string(spec.name));
    ImGui::EndDisabled();
    ImGui::PopID();
    if (!changed) return;
    try {
        panel.stage.change_setting(index, spec.name, value);
        panel.controls.notice.clear();
    } catch (const InputError& error) {
        panel.controls.notice = error.what();
    }
}

/// The everyday settings, the others folded away. False once the contender is gone.
bool draw_run_settings(const Panel& panel, std::size_t index) {
    const Run& run = panel.stage.runs()[index];
    const std::string contender = run.name();
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(colour_of(run)));
    const bool open = region(contender.c_str());
    ImGui::PopStyleColor();
    note(panel.places, contender + " settings");
    if (!open) return true;
    if (!choose_contender(panel.stage, index, panel.places, panel.controls.notice)) return false;
    // The descriptions outlive the settings, which a change replaces.
    const std::span<const SettingSpec> specs = panel.stage.runs()[index].session().settings().specs();
    for (const SettingSpec& spec : specs)
        if (spec.everyday) draw_setting(panel, index, spec);
    if (std::ranges::all_of(specs, &SettingSpec::everyday)) return true;
    const bool more = ImGui::TreeNodeEx("More", ImGuiTreeNodeFlags_NoTreePushOnOpen);
    note(panel.places, contender + ": More");
    for (const SettingSpec& spec : specs)
        if (more && !spec.everyday) draw_setting(panel, index, spec);
    return true;
}

void view_buttons(const Panel& panel) {
    static constexpr std::pair<View, const char*> all[] = {
        {View::single, "Single"}, {View::split, "Split"}, {View::overlay, "Overlay"}};
    const double room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
    for (const auto& [view, name] : all) {
        const bool chosen = panel.stage.view() == view;
        ImGui::PushStyleColor(ImGuiCol_Button,
                              ImGui::GetStyleColorVec4(chosen ? ImGuiCol_ButtonActive : ImGuiCol_Button));
        if (ImGui::Button(name, imgui_vector(std::floor((room - 2 * gap) / 3), 0)))
            panel.stage.set_view(view);
        ImGui::PopStyleColor();
        tooltip("One engine, all side by side, or all on one table (V, or 1, 2, 3)");
        note(panel.places, name);
        if (view != View::overlay) ImGui::SameLine();
    }
}

void reference_switch(const Panel& panel) {
    bool on = panel.stage.reference();
    panel.toggle("Reference", on,
                 "The exact engine, in green: how far are the others from the truth? Its balls fade as its "
                 "own certainty ends, and it stops where it cannot be exact (E)");
    if (!panel.stage.show_reference(on)) panel.controls.notice = no_room;
    if (!panel.stage.reference()) return;
    ImGui::SameLine();
    if (panel.button("Take up again",
                     "Let the reference go on from the state of the first of the others (T)"))
        panel.stage.take_up();
}

}  // namespace

void draw_engines_tab(const Panel& panel) {
    view_buttons(panel);
    reference_switch(panel);
    for (std::size_t i = 0; i < panel.stage.runs().size(); ++i) {
        ImGui::PushID(panel.stage.runs()[i].name().c_str());
        const bool stays = draw_run_settings(panel, i);
        ImGui::PopID();
        if (!stays) break;
    }
    add_contender(panel.stage, panel.places, panel.controls.notice);
}

}  // namespace flipside::app
