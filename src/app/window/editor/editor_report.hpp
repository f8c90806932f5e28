#pragma once
/// What is drawn, for the window's report.

#include <string>

#include "app/window/editor/editor.hpp"

namespace flipside::app {

/// As JSON; places in px of the window.
[[nodiscard]] std::string state_of(const Editor& editor, const Rect& pane, const Camera& camera);

}  // namespace flipside::app
