#pragma once
/// The colour of a contender: its engine's, paler for each other one on the same engine before it.

#include <algorithm>

#include "app/window/run.hpp"
#include "app/window/theme.hpp"

namespace flipside::app {

[[nodiscard]] inline sf::Color colour_of(const Run& run) {
    return blend(engine_colour(run.engine().name), colour::lit, std::min(0.75, 0.5 * run.twin()));
}

}  // namespace flipside::app
