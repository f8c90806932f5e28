#include "app/window/editor/field_set.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/editor/text_field.hpp"
#include "app/window/panel_parts.hpp"

namespace flipside::app {

lab::Path operator/(lab::Path path, const std::string& key) {
    path.push_back(key);
    return path;
}

void FieldSet::end_where_done() const {
    if (ImGui::IsItemDeactivatedAfterEdit()) editor_.draft().end_step();
}

void FieldSet::value(const char* id, const std::string& name, double before, const lab::Path& path,
                     std::size_t at, const FieldSpec& spec) const {
    double shown = before * spec.per_unit;
    const std::string format = std::string("%.7g") + (*spec.unit == '\0' ? "" : " ") + spec.unit;
    if (ImGui::InputDouble(id, &shown, 0, 0, format.c_str(), ImGuiInputTextFlags_AutoSelectAll) &&
        std::isfinite(shown)) {
        constexpr double per_unit = 1e9;  // what was typed in mm stays short in m
        const double typed = std::round(shown / spec.per_unit * per_unit) / per_unit;
        lab::OrderedJson written = lab::number(std::clamp(typed, spec.least, spec.most) + 0.0);
        if (const lab::OrderedJson* pair = find(path); pair != nullptr && pair->is_array()) {
            lab::OrderedJson both = *pair;
            both[at] = written;
            written = both;
        } else if (at < 2) {
            lab::OrderedJson both = lab::OrderedJson::array({spec.usual, spec.usual});
            both[at] = written;
            written = both;
        }
        editor_.draft().set(path, written);
    }
    end_where_done();
    note(places_, name);
}

void FieldSet::number(const lab::Path& path, const FieldSpec& spec) const {
    const lab::OrderedJson* json = find(path);
    label(spec.label, spec.meaning);
    constexpr std::size_t alone = 2;
    value((std::string("##") + spec.label).c_str(), spec.label,
          json == nullptr ? spec.usual : json->get<double>(), path, alone, spec);
}

void FieldSet::pair(const lab::Path& path, const FieldSpec& spec) const {
    label(spec.label, spec.meaning);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    for (const std::size_t i : {0U, 1U}) {
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        const std::string name = std::string(spec.label) + (i == 0 ? " x" : " y");
        const lab::OrderedJson* json = find(path);  // which the other field may have changed
        value(("##" + name).c_str(), name, json == nullptr ? spec.usual : json->at(i).get<double>(), path, i,
              spec);
    }
}

bool FieldSet::typed_text(const char* name, const char* meaning, std::string& text, std::size_t most) const {
    label(name, meaning);
    const bool changed = text_field((std::string("##") + name).c_str(), text, most);
    // Every letter counts at once, and all of them are one step: each begins from what was there before.
    if (changed) editor_.draft().revert_step();
    end_where_done();
    note(places_, name);
    return changed;
}

void FieldSet::text(const lab::Path& path, const char* name, const char* meaning, std::size_t most,
                    bool some) const {
    const lab::OrderedJson* json = find(path);
    std::string text = json == nullptr ? "" : json->get<std::string>();
    if (typed_text(name, meaning, text, most) && !(some && text.empty())) editor_.draft().set(path, text);
}

void FieldSet::toggle(const lab::Path& path, const char* name, const char* meaning) const {
    const lab::OrderedJson* json = find(path);
    bool on = json != nullptr && json->get<bool>();
    if (ImGui::Checkbox(name, &on)) {
        editor_.draft().set(path, on);
        editor_.draft().end_step();
    }
    tooltip(meaning);
    note(places_, name);
}

}  // namespace flipside::app
