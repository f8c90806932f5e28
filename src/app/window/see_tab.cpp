#include <array>
#include <string>

#include "app/window/contender_colour.hpp"
#include "app/window/layout.hpp"
#include "app/window/panel_tabs.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

/// As it is drawn; tracks and velocities have the colour of their engine.
sf::Color legend_colour(Show show, const Stage& stage) {
    switch (show) {
        case Show::contacts:
            return colour::warning;
        case Show::tracks:
        case Show::velocity:
            return colour_of(stage.runs().front());
        case Show::tangents:
            return colour::tangents;
        case Show::pairs:
            return colour::pairs;
        case Show::boxes:
            return colour::boxes;
        case Show::cells:
            return colour::cells;
        case Show::sectors:
            return colour::sectors;
        case Show::hit_points:
        case Show::lights:
        case Show::reticles:
            return colour::lit;
        case Show::sleep:
            break;
    }
    return colour::quiet;
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
        const sf::Color c = legend_colour(static_cast<Show>(i), panel.stage);
        ImGui::GetWindowDrawList()->AddRectFilled({corner.x + 0.2F * size, corner.y + 0.3F * size},
                                                  {corner.x + 0.9F * size, corner.y + size},
                                                  IM_COL32(c.r, c.g, c.b, c.a), 0.2F * size);
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
        for (double scale = 0; scale <= most_scale; scale = scale > 0 ? scale + scale_step : least_scale) {
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
