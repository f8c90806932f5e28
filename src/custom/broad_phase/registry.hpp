#pragma once
/// Every broad phase by name: for the setting, the experiments and the tests.

#include <string_view>

#include "custom/broad_phase/broad_phase.hpp"
#include "world/scene.hpp"
#include "world/settings.hpp"

namespace flipside::custom {

/// What some of them can be told.
struct BroadPhaseOptions {
    Box world;                  ///< where most of the moving boxes are, m
    int quadtree_levels = 4;    ///< 1…8
    int adaptive_capacity = 8;  ///< proxies in a node
    int adaptive_depth = 8;     ///< splits
    double grid_cell = 0;       ///< m, 0: fitted to the boxes
};

struct BroadPhaseKind {
    std::string_view name;   ///< as the setting has it
    std::string_view title;  ///< as facts() and figures have it
    std::unique_ptr<BroadPhase> (*make)(const std::vector<Proxy>& still, const BroadPhaseOptions& options);
};

/// The twin that all are checked against comes first.
inline constexpr BroadPhaseKind broad_phases[] = {
    {"brute", "brute force",
     [](const std::vector<Proxy>& still, const BroadPhaseOptions&) { return make_brute_force(still); }},
    {"quadtree", "quadtree",
     [](const std::vector<Proxy>& still, const BroadPhaseOptions& options) {
         return make_quadtree(still, options.world, options.quadtree_levels);
     }},
    {"adaptive", "adaptive quadtree",
     [](const std::vector<Proxy>& still, const BroadPhaseOptions& options) {
         return make_adaptive_quadtree(still, options.world, options.adaptive_capacity,
                                       options.adaptive_depth);
     }},
    {"grid", "grid",
     [](const std::vector<Proxy>& still, const BroadPhaseOptions& options) {
         return make_grid(still, options.world, options.grid_cell);
     }},
    {"sweep", "sweep and prune",
     [](const std::vector<Proxy>& still, const BroadPhaseOptions&) { return make_sweep(still); }},
};

/// The broad phase that the settings name, or for "auto" the one that suits the scene.
[[nodiscard]] std::unique_ptr<BroadPhase> make_broad_phase(const Scene& scene,
                                                           const std::vector<Proxy>& still,
                                                           const Settings& settings);

/// What "auto" stands for, as the setting would name it.
[[nodiscard]] std::string_view choose_broad_phase(const Scene& scene, std::size_t still_primitives);

}  // namespace flipside::custom
