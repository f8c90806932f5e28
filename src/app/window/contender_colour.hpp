#pragma once
/// The colour of a contender: its engine's; paler or darker where others on the same engine come before it.

#include "app/window/run.hpp"
#include "app/window/theme.hpp"

namespace flipside::app {

[[nodiscard]] inline sf::Color colour_of(const Run& run) {
    const sf::Color color = engine_colour(run.engine().name);
    switch (run.twin()) {
        case 0:
            return color;
        case 1:
            return blend(color, colour::lit, 0.5);
        case 2:
            return blend(color, colour::around, 0.3);
        default:
            return blend(color, colour::lit, 0.85);
    }
}

}  // namespace flipside::app
