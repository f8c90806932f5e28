#include "app/window/panel.hpp"

#include <algorithm>
#include <utility>

#include "app/window/panel_tabs.hpp"

namespace flipside::app {

namespace {

bool tab(const Panel& panel, const char* words, bool wanted) {
    const bool open = ImGui::BeginTabItem(words, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0);
    note(panel.places, words);
    return open;
}

void title(const Panel& panel) {
    WindowControls& controls = panel.controls;
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::TextUnformatted("Flipside");
    ImGui::PopFont();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 5 * ImGui::GetFontSize());
    if (panel.button("Help", "Every key (F1)", 0.66)) controls.help_open = !controls.help_open;
    ImGui::SameLine();
    if (panel.button("»", "Fold the controls away (F2)")) controls.panel_open = false;
}

void tabs(const Panel& panel, const Load& load) {
    WindowControls& controls = panel.controls;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {0.15F * ImGui::GetFontSize(), ImGui::GetStyle().FramePadding.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {0.12F * ImGui::GetFontSize(), 0});
    const bool open = ImGui::BeginTabBar("tabs");
    ImGui::PopStyleVar(2);
    if (!open) return;
    // The tabs stay visible whatever is scrolled below them.
    const auto page = [&](const char* words, bool wanted, const auto& draw) {
        if (!tab(panel, words, wanted)) return;
        const float least = 8 * ImGui::GetTextLineHeightWithSpacing();
        ImGui::BeginChild(words, {0, std::max(least, ImGui::GetContentRegionAvail().y)}, false,
                          ImGuiWindowFlags_NavFlattened);
        draw();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    page("Lesson", std::exchange(controls.lesson_wanted, false),
         [&] { panel.lessons.draw(panel.stage, controls, panel.places); });
    page("Table", std::exchange(controls.table_wanted, false), [&] { draw_table_tab(panel); });
    page("See", false, [&] { draw_see_tab(panel); });
    page("Engines", false, [&] { draw_engines_tab(panel); });
    page("Numbers", false, [&] { draw_numbers_tab(panel, load); });
    ImGui::EndTabBar();
}

/// Says that keys go to the controls, and where they go.
void frame_of_keys(const Rect& place) {
    const ImVec2 corner = imgui_vector(place.x + 1, place.y + 1),
                 end = imgui_vector(place.x + place.width - 1, place.y + place.height - 1);
    ImGui::GetForegroundDrawList()->AddRect(corner, end, ImGui::GetColorU32(imgui_color(colour::lit)));
    wrapped(
        "Keys work these controls: arrows move, Space uses one, Enter types a value. Esc goes back to the "
        "table.",
        colour::lit);
}

}  // namespace

ControlPlaces draw_panel(const Rect& place, Stage& stage, WindowControls& controls, Lessons& lessons,
                         const Load& load) {
    ControlPlaces places;
    ImGui::SetNextWindowPos(imgui_vector(place.x, place.y));
    ImGui::SetNextWindowSize(imgui_vector(place.width, place.height));
    if (!controls.panel_open) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {3, 8});
    ImGui::Begin("controls", nullptr, docked & ~ImGuiWindowFlags_NoScrollbar);
    const Panel panel{stage, controls, places, lessons};
    if (!controls.panel_open) {
        if (panel.button("«", "Open the controls (F2)")) controls.panel_open = true;
        ImGui::End();
        ImGui::PopStyleVar();
        return places;
    }
    if (controls.by_keys && !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows) &&
        !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
        ImGui::SetWindowFocus();
        ImGui::SetKeyboardFocusHere();
    }
    title(panel);
    if (controls.by_keys) frame_of_keys(place);
    draw_notice(controls.notice, places);
    tabs(panel, load);
    ImGui::End();
    return places;
}

}  // namespace flipside::app
