#pragma once
/// What of a scene sounds how: worked out once for all of its parts.

#include <vector>

#include "app/sound/timbre.hpp"
#include "world/scene.hpp"

namespace flipside::app::sound {

/// What a hit of a part sounds like, but for its strength and place.
struct PartSound {
    Source source = Source::wall;
    double pitch = 1;
    double friction = 0, restitution = 1;
};

/// One for each part, from its shape, motion and material: their names mean nothing. Cost: O(n log n).
[[nodiscard]] std::vector<PartSound> part_sounds(const Scene& scene);

/// What is larger sounds lower: the square root of how many times smaller, between half and twice.
[[nodiscard]] double pitch_of_size(double size, Source source);

}  // namespace flipside::app::sound
