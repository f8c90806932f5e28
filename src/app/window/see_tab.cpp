#include <array>
#include <string>
#include <vector>

#include "app/window/contender_colour.hpp"
#include "app/window/layout.hpp"
#include "app/window/panel_tabs.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

/// As it is drawn: in one colour, or in that of every engine on show.
std::vector<sf::Color> legend_colours(Show show, const Stage& stage) {
    std::vector<sf::Color> engines;
    for (const Run& run : stage.runs()) engines.push_back(colour_of(run));
    // On one table each engine shows its insides in its colour.
    const bool own = stage.view() == View::overlay && engines.size() > 1;
    switch (show) {
        case Show::contacts:
            return {colour::warning};
        case Show::tracks:
        case Show::velocity:
            return engines;
        case Show::tangents:
            return {colour::tangents};
        case Show::pairs:
            return own ? engines : std::vector{colour::pairs};
        case Show::boxes:
            return own ? engines : std::vector{colour::boxes};
        case Show::cells:
            return own ? engines : std::vector{colour::cells};
        case Show::sectors:
            return {colour::sectors};
        case Show::hit_points:
        case Show::lights:
        case Show::reticles:
            return {colour::lit};
        case Show::sleep:
            break;
    }
    return {colour::quiet};
}

/// A square of its colours side by side; a dot for what is drawn as one, and a ring with spokes for reticles.
void swatch(Show show, const std::vector<sf::Color>& colors, ImVec2 corner, float size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 middle{corner.x + 0.5F * size, corner.y + 0.5F * size};
    const ImU32 first = ImGui::GetColorU32(imgui_color(colors.front()));
    if (show == Show::hit_points) return list.AddCircleFilled(middle, 0.32F * size, first);
    if (show == Show::reticles) {
        const float thick = 0.12F * size;
        list.AddCircle(middle, 0.33F * size, first, 0, thick);
        for (const float way : {-0.5F, 0.5F}) {
            list.AddLine({middle.x + 0.5F * way * size, middle.y}, {middle.x + way * size, middle.y}, first,
                         thick);
            list.AddLine({middle.x, middle.y + 0.5F * way * size}, {middle.x, middle.y + way * size}, first,
                         thick);
        }
        return;
    }
    const float stripe = size / static_cast<float>(colors.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const float left = corner.x + static_cast<float>(i) * stripe;
        list.AddRectFilled({left, corner.y}, {left + stripe, corner.y + size},
                           ImGui::GetColorU32(imgui_color(colors[i])));
    }
}

void shows(const Panel& panel) {
    if (!ImGui::BeginTable("shows", 2)) return;
    for (std::size_t i = 0; i < show_count; ++i) {
        ImGui::TableNextColumn();
        bool on = panel.controls.look.shows[i];
        panel.toggle(std::string(show_specs[i].label).c_str(), on, show_specs[i].about);
        panel.controls.look.shows[i] = on;
    }
    ImGui::EndTable();
}

/// What is on, in its colour, with what it means.
void legend(const Panel& panel) {
    for (std::size_t i = 0; i < show_count; ++i) {
        if (!panel.controls.look.shows[i]) continue;
        const float size = ImGui::GetFontSize(), indent = 1.5F * size;
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const auto show = static_cast<Show>(i);
        swatch(show, legend_colours(show, panel.stage), {corner.x + 0.2F * size, corner.y + 0.2F * size},
               0.7F * size);
        ImGui::Indent(indent);
        const std::string words = std::string(show_specs[i].label) + ": " + std::string(show_specs[i].about);
        wrapped(words);
        ImGui::Unindent(indent);
    }
}

std::string scale_in_words(double scale) {
    return scale > 0 ? with_unit(scale, 2, "×") : "as suits the window";
}

void letters(const Panel& panel) {
    label("Size of letters", "Of letters, lines and controls (Ctrl + and Ctrl −, Ctrl 0)");
    if (ImGui::BeginCombo("##scale", scale_in_words(panel.controls.scale).c_str())) {
        const ImVec2 window = ImGui::GetIO().DisplaySize;
        const double most = largest_scale(window.x, window.y);
        for (double scale = 0; scale <= most; scale = scale > 0 ? scale + scale_step : least_scale) {
            if (ImGui::Selectable(scale_in_words(scale).c_str(), scale == panel.controls.scale))
                panel.controls.scale = scale;
            note(panel.places, "Size " + scale_in_words(scale));
        }
        ImGui::EndCombo();
    }
    note(panel.places, "Size of letters");
}

void plots(const Panel& panel) {
    label("Plots", "What stands below the table (G for the next ones)");
    const PlotSpec& now = spec_of(panel.controls.plots);
    if (ImGui::BeginCombo("##plots", std::string(now.label).c_str())) {
        for (const PlotSpec& spec : plot_specs) {
            const std::string words(spec.label);
            if (ImGui::Selectable(words.c_str(), spec.choice == now.choice))
                panel.controls.plots = spec.choice;
            note(panel.places, "Plots " + words);
        }
        ImGui::EndCombo();
    }
    note(panel.places, "Plots");
}

void mute(const Panel& panel) {
    panel.toggle("Mute", panel.controls.muted, "No sound (Q)");
    if (!panel.controls.has_sound) wrapped("No device to play sound was found at the start");
}

}  // namespace

void draw_see_tab(const Panel& panel) {
    if (region("On the table")) {
        shows(panel);
        panel.toggle(
            "Artwork", panel.controls.look.artwork,
            "Chart on the ground: the first line is where a ball's centre lies as it touches, each one\n"
            "on is a radius farther. Shadows, trails and sparks; overlays dim it");
        if (panel.controls.look.artwork && panel.controls.artwork_left_out)
            wrapped("Artwork is left out for now: drawing takes too long");
        panel.toggle("Random colours", panel.controls.look.random_colours,
                     "Tint each ball, to tell them apart");
    }
    if (panel.controls.look.shows.any() && region("What it means")) legend(panel);
    if (!region("Window")) return;
    plots(panel);
    letters(panel);
    mute(panel);
}

}  // namespace flipside::app
