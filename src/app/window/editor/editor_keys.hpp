#pragma once
/// The keys of the edit mode, in words, for the help.

#include <string>
#include <utility>
#include <vector>

namespace flipside::app {

/// Key and meaning, in the order of the help.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> edit_key_lines();

}  // namespace flipside::app
