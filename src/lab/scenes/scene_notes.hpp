#pragma once
/// What in a good scene its author may not have meant: nothing here makes a scene wrong.

#include <string>
#include <vector>

#include "world/scene.hpp"

namespace flipside::lab {

/// A line for each ball that starts with its centre in a solid part, or wholly outside the bounds (it is
/// lost at once), and for each pair of balls that start inside one another. Parts in the pose of the scene
/// file; what does not meet (layers, sensors) is left out. Cost: that of a world of the custom engine.
[[nodiscard]] std::vector<std::string> notes_on(const Scene& scene);

}  // namespace flipside::lab
