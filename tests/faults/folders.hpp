#pragma once
/// What lies in a folder, and whether it may lie there after something failed.

#include <filesystem>
#include <map>
#include <string>

#include "child.hpp"

namespace flipside::faults {

/// By name within the folder: the texts of files, as far as they are the same in every undisturbed run
/// (measured times are not).
using Contents = std::map<std::string, std::string>;
[[nodiscard]] Contents contents_of(const std::filesystem::path& folder);

[[nodiscard]] std::string text_of(const std::filesystem::path& file);

/// Each file of `found` is as in `before` or as in `after`: nothing is half, nothing temporary is left. Says
/// "" or what is wrong.
[[nodiscard]] std::string half_files(const Contents& found, const Contents& before, const Contents& after);

/// Exit code 0, or 1 with one clear line on stderr; 2 as well where `may_refuse`. Says "" or what is wrong.
[[nodiscard]] std::string unclear_end(const Ended& ended, bool may_refuse);

}  // namespace flipside::faults
