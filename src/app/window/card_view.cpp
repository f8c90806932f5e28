#include "app/window/card_view.hpp"

#include <algorithm>

#include "app/window/contender_colour.hpp"
#include "app/window/panel_parts.hpp"

namespace flipside::app {

namespace {

/// Around all panes.
Rect around(const std::vector<Rect>& panes) {
    Rect all = panes.front();
    for (const Rect& pane : panes) {
        all.width = std::max(all.width, pane.x + pane.width - all.x);
        all.height = std::max(all.height, pane.y + pane.height - all.y);
    }
    return all;
}

void words(const std::string& text, sf::Color color) {
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(color));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

void draw_rows(const Card& card, const Stage& stage) {
    const int columns = 1 + static_cast<int>(stage.runs().size());
    if (!ImGui::BeginTable("rows", columns, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableNextColumn();
    for (const Run& run : stage.runs()) {
        ImGui::TableNextColumn();
        words(run.name(), colour_of(run));
    }
    for (const Card::Row& row : card.rows) {
        ImGui::TableNextColumn();
        words(row.label, colour::quiet);
        tooltip(row.meaning);
        for (const std::string& cell : row.cells) {
            ImGui::TableNextColumn();
            words(cell, colour::text);
        }
    }
    ImGui::EndTable();
}

}  // namespace

bool draw_card(const Card& card, const Stage& stage, const Layout& layout, std::span<const Rect> watched,
               CardPlace& place, ControlPlaces& places) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSizeConstraints({0, 0}, window);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.5F * ImGui::GetFontSize());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.5F * ImGui::GetFontSize(), 1});
    ImGui::Begin("card", nullptr,
                 (docked & ~(ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar)) |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    words(card.title, colour::text);
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    words(card.about, colour::quiet);
    ImGui::SameLine();
    const bool closed = ImGui::SmallButton("×");
    tooltip("Close (Esc)");
    note(places, "Close card");
    draw_rows(card, stage);
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const Rect& before = place.place();
    const bool elsewhere = at.x != static_cast<float>(before.x) || at.y != static_cast<float>(before.y);
    if (elsewhere && !ImGui::IsWindowAppearing() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        place.move_to({at.x, at.y});
    const Rect now = place.put({size.x, size.y}, around(layout.panes), {0, 0, window.x, window.y}, watched);
    ImGui::SetWindowPos(imgui_vector(now.x, now.y));
    places["Card"] = now;
    ImGui::End();
    ImGui::PopStyleVar(3);
    return !closed;
}

}  // namespace flipside::app
