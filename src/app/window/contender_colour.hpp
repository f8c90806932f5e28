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
            return blend(color, sf::Color::White, 0.4);
        case 2:
            return blend(color, colour::around, 0.3);
        default:
            return blend(color, sf::Color::White, 0.75);
    }
}

}  // namespace flipside::app
