#pragma once
/// What a report says of how it was made.

#include <string>
#include <utility>
#include <vector>

namespace flipside::lab::report {

/// Name and value: machine, system, compiler, flags, libraries, commit.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> build_facts();
/// Today, UTC, as 2026-01-31.
[[nodiscard]] std::string today();

}  // namespace flipside::lab::report
