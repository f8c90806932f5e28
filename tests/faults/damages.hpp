#pragma once
/// What may have become of a file since it was written.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace flipside::faults {

struct Damage {
    const char* name;
    std::function<void(const std::filesystem::path& file)> act;  ///< the file is there
    /// What is in its place is nobody's to remove but its owner's.
    bool is_obstacle = false;
};
/// Those that any data file may meet; `foreign` is a whole one that belongs elsewhere.
[[nodiscard]] std::vector<Damage> damages(const std::filesystem::path& foreign);

}  // namespace flipside::faults
