#include "app/window/panel_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace flipside::app {

ImVec4 imgui_color(sf::Color c) {
    return ImGui::ColorConvertU32ToFloat4(IM_COL32(c.r, c.g, c.b, c.a));
}

namespace {

/// Beside the column where that has room, so that it hides none of its rows; else above the item or below it,
/// and never out of the window.
void show_tooltip(std::string_view words, ImVec2 corner, ImVec2 end) {
    const std::string text = broken(words, 20 * ImGui::GetFontSize());
    const ImVec2 display = ImGui::GetIO().DisplaySize, padding = ImGui::GetStyle().WindowPadding,
                 lines = ImGui::CalcTextSize(text.c_str());
    const ImVec2 size{lines.x + 2 * padding.x, lines.y + 2 * padding.y};
    const float gap = 0.4F * ImGui::GetFontSize();
    const float beside = ImGui::GetWindowPos().x - padding.x - gap - size.x;
    const bool column = beside >= 0 && ImGui::GetWindowHeight() > 0.4F * display.y;
    const float above = corner.y - gap - size.y, below = end.y + gap;
    const float x = column ? beside : corner.x, y = column ? corner.y : above >= 0 ? above : below;
    ImGui::SetNextWindowPos({std::clamp(x, 0.0F, std::max(0.0F, display.x - size.x)),
                             std::clamp(y, 0.0F, std::max(0.0F, display.y - size.y))});
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // of what is disabled too
    ImGui::SetTooltip("%s", text.c_str());        // a control's own in place of that of its line
    ImGui::PopStyleVar();
}

}  // namespace

void tooltip(std::string_view words) {
    if (!words.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        show_tooltip(words, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

float width_of_text(const std::string& words) {
    return ImGui::CalcTextSize(words.c_str()).x;
}

std::string cut(std::string words, float room) {
    return shortened(std::move(words),
                     [room](const std::string& kept) { return width_of_text(kept) <= room; });
}

std::vector<std::string> name_in_lines(const std::string& name, float room) {
    std::vector<std::string> lines{name};
    while (width_of_text(lines.back()) > room) {
        const std::size_t at = lines.back().find('-');
        if (at == std::string::npos || at + 1 == lines.back().size()) break;
        std::string rest = lines.back().substr(at + 1);
        lines.back().resize(at + 1);
        lines.push_back(std::move(rest));
    }
    for (std::string& line : lines) line = cut(line, room);
    return lines;
}

std::vector<std::string> lines_of(std::string_view words, float room, std::size_t most) {
    return in_lines(
        words, [room](const std::string& line) { return width_of_text(line) <= room; }, most);
}

std::string broken(std::string_view words, float room) {
    std::string text;
    for (const std::string& line : lines_of(words, room)) text += (text.empty() ? "" : "\n") + line;
    return text;
}

void wrapped(std::string_view words) {
    ImGui::TextUnformatted(broken(words, ImGui::GetContentRegionAvail().x).c_str());
}

void wrapped(std::string_view words, sf::Color color) {
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(color));
    wrapped(words);
    ImGui::PopStyleColor();
}

void verdict_mark(bool right) {
    draw_verdict(ImGui::GetCursorScreenPos(), right);
    ImGui::Dummy({ImGui::GetFontSize(), ImGui::GetFontSize()});
}

void draw_verdict(ImVec2 corner, bool right) {
    const float size = ImGui::GetFontSize();
    const auto at = [&](float x, float y) { return ImVec2{corner.x + x * size, corner.y + y * size}; };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(imgui_color(right ? colour::text : colour::lit));
    const float thick = 0.12F * size;
    if (right) {
        const ImVec2 tick[] = {at(0.2F, 0.55F), at(0.42F, 0.78F), at(0.82F, 0.25F)};
        list.AddPolyline(tick, 3, color, 0, thick);
    } else {
        list.AddLine(at(0.25F, 0.3F), at(0.75F, 0.8F), color, thick);
        list.AddLine(at(0.75F, 0.3F), at(0.25F, 0.8F), color, thick);
    }
}

void note(ControlPlaces& places, const std::string& label) {
    const ImVec2 min = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    // Its middle, where a click would go; an edge alone may be in sight.
    const ImVec2 middle{min.x + size.x / 2, min.y + size.y / 2};
    if (!ImGui::IsRectVisible(middle, {middle.x + 1, middle.y + 1})) return;
    places[label] = {min.x, min.y, size.x, size.y};
    if (ImGui::IsItemFocused()) places.focus = label;
}

bool region(const char* title, bool open) {
    return ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

void label(std::string_view words, std::string_view meaning) {
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
    const ImVec2 corner = ImGui::GetItemRectMin(),
                 end{ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x, ImGui::GetItemRectMax().y};
    if (!meaning.empty() && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, end))
        show_tooltip(meaning, corner, end);
    const float begin = std::max(0.44F * ImGui::GetContentRegionMax().x,
                                 left + ImGui::GetItemRectSize().x + ImGui::GetStyle().ItemSpacing.x);
    ImGui::SameLine(begin);
    ImGui::SetNextItemWidth(-1);
}

namespace {

bool slider_of(const char* id, ImGuiDataType type, void* value, const void* min, const void* max,
               const char* format, const char* shown, ImGuiSliderFlags flags) {
    const ImGuiID key = ImGui::GetID(id);
    ImGuiStorage& memory = *ImGui::GetStateStorage();
    const bool typing = memory.GetBool(key);
    const float of_shown = ImGui::CalcTextSize(shown).x;
    const float of_value = std::max(4.9F * ImGui::GetFontSize(), of_shown);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::SetNextItemWidth(
        std::max(1.0F, ImGui::GetContentRegionAvail().x - of_value - ImGui::GetStyle().ItemInnerSpacing.x));
    // Only a field shows the value in its own place.
    if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, {0, 0, 0, 0});
    const bool changed =
        ImGui::SliderScalar(id, type, value, min, max, format, flags | ImGuiSliderFlags_AlwaysClamp);
    if (!typing) ImGui::PopStyleColor();
    memory.SetBool(key, ImGui::IsItemActive() && ImGui::GetIO().WantTextInput);
    ImGui::GetWindowDrawList()->AddText(
        {right - of_shown, ImGui::GetItemRectMin().y + ImGui::GetStyle().FramePadding.y},
        ImGui::GetColorU32(ImGuiCol_Text), shown);
    return changed;
}

}  // namespace

bool slider(const char* id, double& value, double min, double max, const char* format,
            ImGuiSliderFlags flags) {
    char shown[64];
    std::snprintf(shown, sizeof shown, format, value);
    return slider_of(id, ImGuiDataType_Double, &value, &min, &max, format, shown, flags);
}

bool slider(const char* id, int& value, int min, int max, ImGuiSliderFlags flags) {
    return slider_of(id, ImGuiDataType_S32, &value, &min, &max, "%d", std::to_string(value).c_str(), flags);
}

bool Panel::button(const char* words, const char* meaning, double share) const {
    const double room = ImGui::GetContentRegionAvail().x;
    const double gap = ImGui::GetStyle().ItemSpacing.x;
    const bool pressed = ImGui::Button(words, imgui_vector(std::floor((room + gap) * share - gap), 0));
    tooltip(meaning);
    note(places, words);
    return pressed;
}

void Panel::toggle(const char* words, bool& on, std::string_view meaning) const {
    ImGui::Checkbox(words, &on);
    tooltip(meaning);
    note(places, words);
}

}  // namespace flipside::app
