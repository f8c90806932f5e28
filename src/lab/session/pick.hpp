#pragma once
/// Finds the ball or part at a point of the table.

#include <optional>
#include <span>

#include "world/events.hpp"
#include "world/state.hpp"

namespace flipside::lab {

/// The ball that covers the point or lies within `reach` m of it, else the part that does; of several the one
/// nearest. Cost: O(n log n) in the primitives of the scene.
[[nodiscard]] std::optional<Other> pick(const Scene& scene, std::span<const Ball> balls,
                                        std::span<const PartState> parts, Vec2 point, double reach);

/// A box around a part as it stands. Cost: as pick.
[[nodiscard]] Box extent_of(const Scene& scene, std::span<const PartState> parts, PartIndex part);

/// Whether a ball may be put there: within the bounds, and overlapping nothing that it would collide with.
/// Cost: as pick.
[[nodiscard]] bool is_free(const Scene& scene, std::span<const Ball> balls, std::span<const PartState> parts,
                           const Ball& ball);

}  // namespace flipside::lab
