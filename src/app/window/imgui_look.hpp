#pragma once
/// Style and fonts of Dear ImGui, as the rest of the window has them.

#include <cstdint>

namespace flipside::app {

/// At another scale than before too. Throws std::runtime_error when there are no fonts.
void set_imgui_look(double scale);

/// Whether a character is among the letters that are loaded; "?" stands for all others.
[[nodiscard]] bool is_lettered(std::uint32_t code_point);

}  // namespace flipside::app
