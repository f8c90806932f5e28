#pragma once
/// What a scene's document says is on the table, also while it says something that no table can be: a wall
/// without length, a polygon with a dent. It is to be seen and pointed at, not to be run.

#include "lab/editor/json_text.hpp"
#include "world/scene.hpp"

namespace flipside::lab {

/// Parts and balls as they are listed, in that order; nothing that is generated. The document has the form of
/// the schema.
[[nodiscard]] Scene sketch_of(const OrderedJson& document);
/// One shape of it.
[[nodiscard]] Shape sketch_of_shape(const OrderedJson& json);

[[nodiscard]] Vec2 vector_of(const OrderedJson& pair);
[[nodiscard]] OrderedJson to_pair(Vec2 v);

}  // namespace flipside::lab
