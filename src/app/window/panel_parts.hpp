#pragma once
/// The regions of the control column, and how they are laid out: a label on the left, its control on the
/// right, what it means in a tooltip.

#include <string>
#include <string_view>

#include <SFML/Graphics/Color.hpp>
#include <imgui.h>

#include "app/window/controls.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// Of a window that is part of the layout.
inline constexpr ImGuiWindowFlags docked =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

[[nodiscard]] inline ImVec2 imgui_vector(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}
/// Shows `words` while the mouse rests on the last item.
void tooltip(std::string_view words);
/// Notes where the last item is.
void note(ControlPlaces& places, const std::string& label);
/// A foldable region; true while it is open.
bool region(const char* title, bool open = true);
/// The label of the control that follows, which gets the rest of the line.
void label(std::string_view words, std::string_view meaning);
[[nodiscard]] ImVec4 imgui_color(sf::Color color);

/// Balls in play, tests and hits, broad phase: one column per run.
void draw_counts(const Stage& stage);
/// The settings of every engine on show, each under its colour, made from their descriptions.
/// What an engine refuses becomes the `notice`.
void draw_settings(Stage& stage, ControlPlaces& places, std::string& notice);

}  // namespace flipside::app
