#include "app/window/panel_parts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/window/contender_choice.hpp"
#include "app/window/contender_colour.hpp"
#include "app/window/words.hpp"
#include "world/input_error.hpp"

namespace flipside::app {

void tooltip(std::string_view words) {
    if (words.empty() || !ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(20 * ImGui::GetFontSize());
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void note(ControlPlaces& places, const std::string& label) {
    const ImVec2 min = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    // Its middle, where a click would go; an edge alone may be in sight.
    const ImVec2 middle{min.x + size.x / 2, min.y + size.y / 2};
    if (!ImGui::IsRectVisible(middle, {middle.x + 1, middle.y + 1})) return;
    places[label] = {min.x, min.y, size.x, size.y};
}

bool region(const char* title, bool open) {
    return ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

void label(std::string_view words, std::string_view meaning) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
    tooltip(meaning);
    ImGui::SameLine(0.46F * ImGui::GetContentRegionMax().x);
    ImGui::SetNextItemWidth(-1);
}

ImVec4 imgui_color(sf::Color c) {
    return ImGui::ColorConvertU32ToFloat4(IM_COL32(c.r, c.g, c.b, c.a));
}

namespace {

/// "motion_iterations" as people write it.
std::string in_words(std::string_view name) {
    std::string words(name);
    std::ranges::replace(words, '_', ' ');
    return sentence(words);
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
            const bool changed =
                ImGui::SliderInt("##value", &number, static_cast<int>(spec.min), static_cast<int>(spec.max),
                                 "%d", ImGuiSliderFlags_AlwaysClamp);
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
    const bool wide = spec.min > 0 && spec.max / spec.min > 100;
    return ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &spec.min, &spec.max, format.c_str(),
                               ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat |
                                   (wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None));
}

/// False once the contender is gone.
bool draw_run_settings(Stage& stage, std::size_t index, ControlPlaces& places, std::string& notice) {
    const std::string contender = stage.runs()[index].name();
    ImGui::PushID(contender.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(colour_of(stage.runs()[index])));
    const bool open = region((contender + " settings").c_str());
    ImGui::PopStyleColor();
    if (open && !choose_contender(stage, index, places, notice)) {
        ImGui::PopID();
        return false;
    }
    const lab::Session& session = stage.runs()[index].session();
    // The description outlives the settings, which a change replaces.
    for (const SettingSpec& spec : session.settings().specs()) {
        if (!open) break;
        const std::string name(spec.name);
        const std::string unit = spec.unit.empty() ? "" : " (" + std::string(spec.unit) + ")";
        const std::string meaning = std::string(spec.about) + unit;
        ImGui::PushID(name.c_str());
        label(in_words(spec.name), meaning);
        double value = 0;
        const bool changed = edit(spec, session.settings(), value);
        tooltip(meaning);
        note(places, contender + "." + name);
        ImGui::PopID();
        if (!changed) continue;
        try {
            stage.change_setting(index, name, value);
            notice.clear();
        } catch (const InputError& error) {
            notice = error.what();
        }
    }
    ImGui::PopID();
    return true;
}

using Value = std::function<std::string(const Run&)>;

/// One line: what it is, and its value for each run.
void row(const Stage& stage, const char* words, const char* meaning, const Value& value) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(words);
    tooltip(meaning);
    for (const Run& run : stage.runs()) {
        ImGui::TableNextColumn();
        const std::string text = value(run);
        const float slack = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
        if (slack > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + slack);
        ImGui::TextUnformatted(text.c_str());
    }
}

bool begin_table(const Stage& stage, const char* id) {
    const int columns = 1 + static_cast<int>(stage.runs().size());
    if (!ImGui::BeginTable(id, columns, ImGuiTableFlags_SizingStretchProp)) return false;
    ImGui::TableSetupColumn("", 0, 1.7F);
    for (std::size_t i = 0; i < stage.runs().size(); ++i) ImGui::TableSetupColumn("", 0, 1);
    ImGui::TableNextColumn();
    for (const Run& run : stage.runs()) {
        ImGui::TableNextColumn();
        const std::string& name = run.name();
        const float slack = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(name.c_str()).x;
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, slack));
        ImGui::TextColored(imgui_color(colour_of(run)), "%s", name.c_str());
    }
    return true;
}

std::string whole(double number) {
    return grouped(static_cast<std::uint64_t>(std::llround(number)));
}

void balls_in_play(const Stage& stage) {
    if (!begin_table(stage, "balls")) return;
    row(stage, "On the table", "Balls in the world now",
        [](const Run& run) { return grouped(run.session().world().balls().size()); });
    row(stage, "Launched", "Balls that entered since the start",
        [](const Run& run) { return grouped(run.session().totals().launched); });
    row(stage, "Overlaps", "Balls at the exact position of another",
        [](const Run& run) { return grouped(run.rates().overlaps); });
    row(stage, "Strays", "Balls that left the table where there is no way out",
        [](const Run& run) { return grouped(run.session().totals().strays); });
    row(stage, "Drained", "Balls that left it otherwise",
        [](const Run& run) { return grouped(run.session().totals().lost - run.session().totals().strays); });
    ImGui::EndTable();
}

void detection(const Stage& stage) {
    if (!begin_table(stage, "tests")) return;
    row(stage, "AABB tests per step", "Tests of one bounding box against another, insertion included",
        [](const Run& run) { return whole(run.rates().pair_tests_per_step); });
    row(stage, "AABB tests/s", "The same per second of your time",
        [](const Run& run) { return whole(run.rates().pair_tests); });
    row(stage, "Full tests per step", "Tests of one shape against another, after their boxes overlap",
        [](const Run& run) { return whole(run.rates().narrow_tests_per_step); });
    row(stage, "Full tests/s", "The same per second of your time",
        [](const Run& run) { return whole(run.rates().narrow_tests); });
    row(stage, "Collisions/s", "Impacts per second of your time",
        [](const Run& run) { return whole(run.rates().impacts); });
    row(stage, "Time per step", "CPU time that the engine takes for one step",
        [](const Run& run) { return engineering(run.rates().step_seconds, "s"); });
    ImGui::EndTable();
}

void broad_phase(const Stage& stage) {
    if (!begin_table(stage, "broad")) return;
    const auto fact = [](auto member) {
        return [member](const Run& run) {
            const BroadPhaseFacts& facts = run.session().world().statistics().broad_phase;
            return facts.*member > 0 ? whole(facts.*member) : std::string("–");
        };
    };
    row(stage, "Kind", "How the engine finds what is near", [](const Run& run) {
        const std::string_view name = run.session().world().statistics().broad_phase.name;
        return name.empty() ? std::string("–") : std::string(name);
    });
    row(stage, "Levels", "Depth of the tree", fact(&BroadPhaseFacts::levels));
    row(stage, "Nodes", "Nodes of the tree", fact(&BroadPhaseFacts::nodes));
    row(stage, "Leaves", "Leaves, or cells", fact(&BroadPhaseFacts::leaves));
    row(stage, "Leaf size, mm", "Width and height of a leaf, mm", [](const Run& run) {
        const BroadPhaseFacts& facts = run.session().world().statistics().broad_phase;
        return facts.leaf_width > 0 ? whole(1000 * facts.leaf_width) + " × " + whole(1000 * facts.leaf_height)
                                    : std::string("–");
    });
    row(stage, "Most in a leaf", "Shapes in the fullest leaf", fact(&BroadPhaseFacts::most_in_leaf));
    ImGui::EndTable();
}

}  // namespace

void draw_settings(Stage& stage, ControlPlaces& places, std::string& notice) {
    for (std::size_t i = 0; i < stage.runs().size(); ++i)
        if (!draw_run_settings(stage, i, places, notice)) break;
    add_contender(stage, places, notice);
}

void draw_counts(const Stage& stage) {
    if (region("Balls in play")) balls_in_play(stage);
    if (region("Detection and response")) detection(stage);
    if (region("Broad phase")) broad_phase(stage);
}

}  // namespace flipside::app
