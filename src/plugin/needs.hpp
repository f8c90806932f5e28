#pragma once
/// What a scene needs of an engine beyond gravity and restitution, by the names of the interface.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "world/surface.hpp"

namespace flipside::plugin {

struct Feature {
    std::uint64_t bit;
    std::string_view name;  ///< in the plural, as "gates"
};
/// All that the interface knows.
[[nodiscard]] std::span<const Feature> features();

/// What the scene needs of what is not offered, each with a part or ball for which it does: "gates (part
/// 'gate'), friction (ball 0)". Empty where there is nothing. `primitives` is the surface of the scene.
[[nodiscard]] std::string missing_features(const Scene& scene, const std::vector<Primitive>& primitives,
                                           std::uint64_t offered);

}  // namespace flipside::plugin
