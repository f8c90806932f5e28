#pragma once
/// Mutations of a scene, for the search of a hunt.

#include <optional>

#include "lab/hunt/random_scene.hpp"

namespace flipside::lab::hunt {

/// A scene that differs in one to three things: a ball's place, velocity, radius, mass or spin, a part's
/// place, a material, the whole scene's gravity or drag; a ball or part more or less. At most six balls, and
/// five parts besides the first, which is the box; masses from 0.03 to 30 kg.
[[nodiscard]] Scene neighbour_of(const Scene& scene, RandomScene& random);

/// As a scene file has it: what it means after it was written and read, with the text. Nothing for what is no
/// valid scene, and for one in which no ball is left that begins clear of all else.
struct Written {
    std::string text;
    Scene scene;
};
[[nodiscard]] std::optional<Written> written(Scene scene);

}  // namespace flipside::lab::hunt
