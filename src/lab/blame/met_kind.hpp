#pragma once
/// What a ball met, from the scene: the kind of primitive at a point, and the normal that it has.

#include <string_view>

#include "lab/blame/blame.hpp"
#include "world/state.hpp"

namespace flipside::lab {

/// One of met_kinds. `point` is in the world's frame, `state` that of the part. Cost: linear in the
/// primitives of the scene.
[[nodiscard]] std::string_view met_kind(const Scene& scene, Other other, const PartState& state, Vec2 point);

/// The normal of a part's surface nearest to a disc there, from the surface to the disc. Cost as above.
[[nodiscard]] Vec2 surface_normal(const Scene& scene, PartIndex part, const PartState& state, Vec2 center,
                                  double radius);

/// The distance of a disc from the surface of a part, m; below 0 where they overlap. Cost as above.
[[nodiscard]] double separation(const Scene& scene, PartIndex part, const PartState& state, Vec2 center,
                                double radius);

}  // namespace flipside::lab
