#pragma once
/// What the tabs of the control column are made of: a label on the left, its control on the right, what it
/// means in a tooltip.

#include <string>
#include <string_view>
#include <vector>

#include <SFML/Graphics/Color.hpp>
#include <imgui.h>

#include "app/window/controls.hpp"
#include "app/window/lesson_tab.hpp"
#include "app/window/stage.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

/// Of a window that is part of the layout.
inline constexpr ImGuiWindowFlags docked =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

[[nodiscard]] inline ImVec2 imgui_vector(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}
[[nodiscard]] ImVec4 imgui_color(sf::Color color);
/// Shows `words` beside the column, or above anything else, while the mouse rests on the last item.
void tooltip(std::string_view words);
/// In the letters of now, px.
[[nodiscard]] float width_of_text(const std::string& words);
/// As it is shown in a line with so much room, px: with an ellipsis where that is too little for all of it.
[[nodiscard]] std::string cut(std::string words, float room);
/// A contender's name for which there is no room, px, is broken behind its hyphens: "box2d-cold" and
/// "box2d-warm" differ at their ends.
[[nodiscard]] std::vector<std::string> name_in_lines(const std::string& name, float room);
/// In lines with so much room, px (words.hpp); `broken`: in one text.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view words, float room,
                                                std::size_t most = any_number);
[[nodiscard]] std::string broken(std::string_view words, float room);
/// In the lines that the rest of the column has room for.
void wrapped(std::string_view words);
void wrapped(std::string_view words, sf::Color color);
/// A check mark or a cross, as wide as a letter is high, with its upper left corner there, or as an item.
void draw_verdict(ImVec2 corner, bool right);
void verdict_mark(bool right);
/// Notes where the last item is, if it is to be seen.
void note(ControlPlaces& places, const std::string& label);
/// A foldable region; true while it is open.
bool region(const char* title, bool open = true);
/// The label of the control that follows, which gets the rest of the line. `meaning` is told over both.
void label(std::string_view words, std::string_view meaning);
/// With the value beside it, where no grab hides it; a click with Ctrl opens a field to type it into.
/// `format` as in printf.
bool slider(const char* id, double& value, double min, double max, const char* format,
            ImGuiSliderFlags flags = ImGuiSliderFlags_None);
bool slider(const char* id, int& value, int min, int max, ImGuiSliderFlags flags = ImGuiSliderFlags_None);

/// What every tab works on.
struct Panel {
    Stage& stage;
    WindowControls& controls;
    ControlPlaces& places;
    Lessons& lessons;

    /// As wide as `share` of what is left of the line.
    bool button(const char* words, const char* meaning, double share = 1) const;
    void toggle(const char* words, bool& on, std::string_view meaning) const;
};

}  // namespace flipside::app
