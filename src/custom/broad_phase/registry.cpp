#include "custom/broad_phase/registry.hpp"

#include <algorithm>

namespace flipside::custom {

namespace {

/// Up to this many pairs, brute force is the cheapest.
constexpr std::size_t few_pairs = 64;
/// Ratio of the largest radius to the smallest from which one width of cells does not fit all balls.
constexpr double mixed_sizes = 16;

/// Name of the broad phase that "auto" chooses.
std::string_view choose_broad_phase(const Scene& scene, std::size_t still_primitives) {
    const std::size_t balls = scene.balls.size();
    if (!scene.launcher && balls * (balls + still_primitives) <= few_pairs) return "brute";
    const auto [least, most] = std::ranges::minmax_element(scene.balls, {}, &Ball::radius);
    if (least != scene.balls.end() && most->radius > mixed_sizes * least->radius) return "adaptive";
    return "grid";
}

}  // namespace

std::unique_ptr<BroadPhase> make_broad_phase(const Scene& scene, const std::vector<Proxy>& still,
                                             const Settings& settings) {
    std::string_view kind = settings.choice("broad_phase");
    if (kind == "auto") kind = choose_broad_phase(scene, still.size());
    const BroadPhaseOptions options{scene.bounds, settings.integer("quadtree_levels"),
                                    settings.integer("adaptive_capacity"), settings.integer("adaptive_depth"),
                                    settings.real("grid_cell")};
    return std::ranges::find(broad_phases, kind, &BroadPhaseKind::name)->make(still, options);
}

}  // namespace flipside::custom
