#pragma once
/// What can be put on a table, and how it is drawn: by so many points, one after another.

#include <span>
#include <string_view>

#include "lab/editor/sketch.hpp"

namespace flipside::lab {

struct Tool {
    std::string_view name;  ///< as on its button
    char letter;            ///< of the key that takes it
    std::string_view stem;  ///< of the names of what it makes
    int points;             ///< that it takes; 0: as many as wanted
    std::string_view hint;  ///< what to do
};

/// In the order of the buttons. The first one selects and makes nothing.
[[nodiscard]] std::span<const Tool> tools();

/// What a tool makes of these points, with the name: a part, a ball or a launcher. Sizes that points do not
/// say suit a table on which a ball has that radius, m. Two points at one place are taken for a short way to
/// the right.
[[nodiscard]] OrderedJson made(const Tool& tool, std::span<const Vec2> points, const std::string& name,
                               double ball_radius);
/// Where it belongs in a document.
[[nodiscard]] std::string_view place_of(const Tool& tool);

/// An empty table, as the text of a scene file.
[[nodiscard]] std::string new_scene();

}  // namespace flipside::lab
