#include "app/window/strip.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/panel_parts.hpp"

namespace flipside::app {

void drag_strip(const Layout& layout, double scale, WindowControls& controls, ControlPlaces& places) {
    constexpr double reach = 4;  // px on an ordinary display, to either side of the edge
    const Rect& strip = layout.strip;
    if (strip.height == 0) return;
    const double height = std::round(2 * reach * scale);
    const ImVec2 corner = imgui_vector(strip.x, strip.y - height), size = imgui_vector(strip.width, height);
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("edge of the plots", nullptr,
                 docked | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton("edge", size);
    note(places, "Edge of the plots");
    const bool held = ImGui::IsItemActive();
    if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1))
        controls.strip = strip_height(strip.y + strip.height - ImGui::GetIO().MousePos.y - 0.5 * height,
                                      ImGui::GetIO().DisplaySize.y, scale, controls.bar_open) /
                         scale;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) controls.strip = 0;
    const float middle = corner.x + 0.5F * size.x, y = corner.y + 0.7F * size.y;
    const float half = held || ImGui::IsItemHovered() ? 0.5F * size.x : static_cast<float>(18 * scale);
    ImGui::GetWindowDrawList()->AddLine({middle - half, y}, {middle + half, y},
                                        ImGui::GetColorU32(ImGuiCol_TextDisabled),
                                        static_cast<float>(2 * scale));
    tooltip("Drag to make the plots higher or lower; a double click makes them as they were");
    ImGui::End();
}

void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage, PlotChoice choice, Vec2 mouse) {
    if (place.height == 0) return;
    std::vector<Plot> plots = plots_of(choice, stage);
    // In a narrow window the first ones, so that each can be read.
    const double least = canvas.scaled(140);
    plots.resize(std::clamp<std::size_t>(static_cast<std::size_t>(place.width / least), 1, plots.size()));
    const PlotTime time{stage.time(), 2.5 * stage.dt(), mouse};
    const double gap = canvas.scaled(6), count = static_cast<double>(plots.size());
    const double width = std::floor((place.width - (count - 1) * gap) / count);
    for (std::size_t i = 0; i < plots.size(); ++i)
        draw_plot(canvas, {place.x + static_cast<double>(i) * (width + gap), place.y, width, place.height},
                  plots[i], time);
}

}  // namespace flipside::app
