#include "app/window/display.hpp"

#include <algorithm>

#include <SFML/Window/VideoMode.hpp>

#include "app/window/layout.hpp"

namespace flipside::app {

double scale_for(sf::Vector2u size, double wanted) {
    if (wanted > 0) return std::min(wanted, largest_scale(size.x, size.y));
    return usual_scale(sf::VideoMode::getDesktopMode().height, size.x, size.y);
}

// SFML 2.5 takes the display's width for its height, so a window that no window manager moves is cut off
// below.
sf::Vector2i middle_for(sf::Vector2u size) {
    const sf::VideoMode display = sf::VideoMode::getDesktopMode();
    const auto margin = [](unsigned all, unsigned own) {
        return all > own ? static_cast<int>((all - own) / 2) : 0;
    };
    return {margin(display.width, size.x), margin(display.height, size.y)};
}

}  // namespace flipside::app
