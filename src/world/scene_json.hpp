#pragma once
/// A scene written as a scene file.

#include <string>

#include "world/scene.hpp"

namespace flipside {

/// One line that parse_scene() takes: every ball and part on its own, whatever generated them. Angles are in
/// degrees there, so they come back to within a rounding; all else comes back to the bit.
[[nodiscard]] std::string to_json(const Scene& scene);

}  // namespace flipside
