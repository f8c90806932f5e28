#pragma once
/// Draws the bounds of balls and parts (Topic::boxes). Of moving parts also the bounds that turn with them:
/// circle and rectangle.

#include "custom/layout.hpp"
#include "world/inspector.hpp"

namespace flipside::custom {

void inspect_bounds(const Layout& layout, const Table& table, std::span<const Ball> balls,
                    Inspector& inspector);

}  // namespace flipside::custom
