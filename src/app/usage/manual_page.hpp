#pragma once
/// The man page, written from the descriptions that --help prints.

#include <string>

#include "app/usage/description.hpp"

namespace flipside::app {

/// In the macros of man(7). `date` as 2026-11-24, that of the release.
[[nodiscard]] std::string manual_page(const ProgramDescription& program, const std::string& date);

}  // namespace flipside::app
