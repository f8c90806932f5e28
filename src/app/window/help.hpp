#pragma once
/// Every key and what it does.

#include <string>
#include <utility>
#include <vector>

#include "app/window/controls.hpp"

namespace flipside::app {

/// Keys and what they mean, in the order of the help.
using KeyLines = std::vector<std::pair<std::string, std::string>>;

/// Of the table.
[[nodiscard]] KeyLines key_lines();
/// In the middle of `place`. Notes where each line is, as "help: KEYS".
void draw_help(const Rect& place, const KeyLines& lines, ControlPlaces& places);

}  // namespace flipside::app
