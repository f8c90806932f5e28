#pragma once
/// For tests of what must hold on every engine.

#include <algorithm>

#include "lab/contenders/engines.hpp"

namespace flipside::lab {

/// Every engine, and every solver of one that has several.
inline std::vector<std::pair<const Engine*, Settings>> every_solver() {
    std::vector<std::pair<const Engine*, Settings>> found;
    for (const Engine* engine : engines()) {
        const auto solver = std::ranges::find(engine->settings, "solver", &SettingSpec::name);
        if (solver == engine->settings.end()) {
            found.emplace_back(engine, Settings(engine->settings));
            continue;
        }
        for (const std::string_view value : solver->choices) {
            found.emplace_back(engine, Settings(engine->settings));
            found.back().second.set("solver", value);
        }
    }
    return found;
}

}  // namespace flipside::lab
