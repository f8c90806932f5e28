#include "app/window/card_view.hpp"

#include <algorithm>
#include <vector>

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

/// As wide as the name and the widest of the cells, or as its share of `room`, px.
float width_of_column(const Card& card, const std::string& name, std::size_t column, float room) {
    float width = width_of_text(name), labels = 0;
    for (const Card::Row& row : card.rows) {
        width = std::max(width, width_of_text(row.cells[column]));
        labels = std::max(labels, width_of_text(row.label));
    }
    const float padding = 2 * ImGui::GetStyle().CellPadding.x;
    const auto count = static_cast<float>(card.rows.front().cells.size());
    return std::min(width, std::max(4 * ImGui::GetFontSize(), (room - labels - padding) / count - padding));
}

/// In so much room, px.
void draw_rows(const Card& card, const Stage& stage, float room) {
    const std::size_t columns = stage.runs().size();
    if (card.rows.empty() ||
        !ImGui::BeginTable("rows", 1 + static_cast<int>(columns), ImGuiTableFlags_SizingFixedFit))
        return;
    std::vector<float> widths;
    ImGui::TableNextColumn();
    for (const Run& run : stage.runs()) {
        ImGui::TableNextColumn();
        widths.push_back(width_of_column(card, run.name(), widths.size(), room));
        std::string name;
        for (const std::string& line : name_in_lines(run.name(), widths.back()))
            name += (name.empty() ? "" : "\n") + line;
        words(name, colour_of(run));
        tooltip(run.name());
    }
    for (const Card::Row& row : card.rows) {
        ImGui::TableNextColumn();
        words(row.label, colour::quiet);
        tooltip(row.meaning);
        for (std::size_t i = 0; i < columns; ++i) {
            ImGui::TableNextColumn();
            words(broken(row.cells[i], widths[i]), colour::text);
        }
    }
    ImGui::EndTable();
}

}  // namespace

bool draw_card(const Card& card, const Stage& stage, const Layout& layout, std::span<const Rect> watched,
               CardPlace& place, ControlPlaces& places) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const Rect panes = around(layout.panes);
    // With large letters in a small window the wheel goes through what has no room.
    const ImVec2 most{std::max(static_cast<float>(panes.width), 0.5F * window.x),
                      std::max(static_cast<float>(panes.height), 0.5F * window.y)};
    ImGui::SetNextWindowSizeConstraints({0, 0}, most);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.5F * ImGui::GetFontSize());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.5F * ImGui::GetFontSize(), 1});
    ImGui::Begin("card", nullptr,
                 (docked & ~(ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar)) |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    words(card.title, colour::text);
    ImGui::PopFont();
    const float room = most.x - 2 * ImGui::GetStyle().WindowPadding.x;
    const bool in_line =
        ImGui::GetItemRectSize().x + width_of_text(card.about) + 3 * ImGui::GetFontSize() < room;
    const auto about = [&] { words(broken(card.about, room), colour::quiet); };
    ImGui::SameLine();
    if (in_line) {
        ImGui::AlignTextToFramePadding();
        about();
        ImGui::SameLine();
    }
    const bool closed = ImGui::SmallButton("×");
    tooltip("Close (Esc)");
    note(places, "Close card");
    if (!in_line) about();
    draw_rows(card, stage, room);
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const Rect& before = place.place();
    const bool elsewhere = at.x != static_cast<float>(before.x) || at.y != static_cast<float>(before.y);
    if (elsewhere && !ImGui::IsWindowAppearing() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        place.move_to({at.x, at.y});
    const Rect now = place.put({size.x, size.y}, panes, {0, 0, window.x, window.y}, watched);
    ImGui::SetWindowPos(imgui_vector(now.x, now.y));
    places["Card"] = now;
    ImGui::End();
    ImGui::PopStyleVar(3);
    return !closed;
}

}  // namespace flipside::app
