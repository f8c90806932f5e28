#pragma once
/// The table of all broad phases, for the setting, the experiments and the tests.

#include <string_view>

#include "custom/broad_phase/broad_phase.hpp"
#include "world/scene.hpp"
#include "world/settings.hpp"

namespace flipside::custom {

struct BroadPhaseKind {
    std::string_view name;   ///< in the setting
    std::string_view title;  ///< in facts() and figures
    MakeBroadPhase* make;
};

/// Brute force, against which all others are tested, comes first.
inline constexpr BroadPhaseKind broad_phases[] = {
    {"brute", "brute force", make_brute_force},
    {"quadtree", "quadtree", make_quadtree},
    {"adaptive", "adaptive quadtree", make_adaptive_quadtree},
    {"grid", "grid", make_grid},
    {"sweep", "sweep and prune", make_sweep},
};

/// The broad phase of the settings; "auto" chooses one by the scene and the number of still proxies.
[[nodiscard]] std::unique_ptr<BroadPhase> make_broad_phase(const Scene& scene,
                                                           const std::vector<Proxy>& still,
                                                           const Settings& settings);

}  // namespace flipside::custom
