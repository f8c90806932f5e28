#pragma once
/// A foreign engine as all others offer themselves.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/description.hpp"
#include "world/engine.hpp"

namespace flipside::plugin {

/// A library, and what it is called here. Stays where it is: worlds and settings point into it.
struct Plugin {
    std::string file;  ///< its canonical path
    std::string name;
    Description description;
    std::vector<std::vector<std::string_view>> choices;  ///< of each setting
    std::vector<SettingSpec> settings;
    Engine engine;
    /// Calls that were not answered in time. Once there are most_silences it is not asked any more: what runs
    /// it a thousand times shall end.
    mutable int silences = 0;
};
inline constexpr int most_silences = 3;

/// Loads a library in a process of its own, and lets it go again. Its name is the one that it gives itself,
/// made a plain word and different from all that are `taken`. Throws InputError where it is no engine or its
/// process ends.
[[nodiscard]] std::unique_ptr<const Plugin> load(const std::filesystem::path& file,
                                                 std::span<const std::string_view> taken);

}  // namespace flipside::plugin
