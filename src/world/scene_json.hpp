#pragma once
/// A scene written as a scene file.

#include <string>

#include "world/scene.hpp"

namespace flipside {

/// One line that parse_scene() takes: every ball and part on its own, whatever generated them. Angles are in
/// degrees there, so they come back to within a rounding; all else comes back to the bit.
[[nodiscard]] std::string to_json(const Scene& scene);
/// What states of a scene depend on, as text: the bounds and what becomes of lost balls, layers and parts.
/// Gravity, drag, materials and the balls of the start may change and a state still makes sense.
[[nodiscard]] std::string table_text(const Scene& scene);

}  // namespace flipside
