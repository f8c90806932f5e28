#include "app/window/help.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/window/keys.hpp"
#include "app/window/panel_parts.hpp"
#include "app/window/theme.hpp"

namespace flipside::app {

KeyLines key_lines() {
    KeyLines lines;
    for (const KeyUse& use : key_uses()) lines.emplace_back(use.names, use.meaning);
    lines.emplace_back("Gamepad", "Shoulders or triggers: flippers; Start: pause");
    lines.emplace_back("", "A, or right stick down: launch; left stick or cross: nudge");
    lines.emplace_back("Wheel, drag", "Zoom, move the table");
    lines.emplace_back("Double click", "Fit the table to its pane");
    lines.emplace_back("Click", "Pick a ball or part: its card says all about it");
    lines.emplace_back("Drag a ball", "Throw it: pull it back and let go");
    lines.emplace_back("Ctrl click", "Add a ball (Shift too); on a slider: type its value");
    return lines;
}

namespace {

/// All that is below the help, darker.
void draw_shade(const Rect& place) {
    ImGui::SetNextWindowPos(imgui_vector(place.x, place.y));
    ImGui::SetNextWindowSize(imgui_vector(place.width, place.height));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, imgui_color(with_alpha(colour::around, 0.6)));
    ImGui::Begin("help shade", nullptr, docked | ImGuiWindowFlags_NoInputs);
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace

void draw_help(const Rect& place, const KeyLines& lines, ControlPlaces& places) {
    draw_shade(place);
    const float size = ImGui::GetFontSize();
    const float of_keys = 7.4F * size, beside = 0.42F * static_cast<float>(place.width) - of_keys;
    // One below the other where they have room for that, or none beside each other.
    const bool one_column =
        1.5 * size * static_cast<double>(lines.size() + 4) < place.height || beside < 12 * size;
    const float of_meaning =
        std::min(27 * size, one_column ? 0.85F * static_cast<float>(place.width) - of_keys : beside);
    const std::size_t columns = one_column ? 1 : 2;
    const std::size_t rows = (lines.size() + columns - 1) / columns;

    ImGui::SetNextWindowPos(imgui_vector(place.x + place.width / 2, place.y + place.height / 2),
                            ImGuiCond_Always, {0.5F, 0.5F});
    // Of whole pixels, or else the wheel has half a pixel to go through.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {std::round(1.2F * size), std::round(0.7F * size)});
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {std::round(0.4F * size), std::round(0.06F * size)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.5F * size);
    // With large letters in a small window the wheel goes through what has no room.
    ImGui::SetNextWindowSizeConstraints({0, 0}, imgui_vector(place.width, place.height));
    ImGui::Begin("help", nullptr,
                 (docked & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoNav);
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::TextUnformatted("Keys");
    ImGui::PopFont();
    if (ImGui::BeginTable("keys", static_cast<int>(2 * columns), ImGuiTableFlags_SizingFixedFit)) {
        for (std::size_t i = 0; i < columns; ++i) {
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, of_keys);
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, of_meaning);
        }
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t i = row; i < lines.size(); i += rows) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(lines[i].first.c_str());
                ImGui::TableNextColumn();
                wrapped(lines[i].second, colour::quiet);
                note(places, "help: " + lines[i].first);
            }
        ImGui::EndTable();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace flipside::app
