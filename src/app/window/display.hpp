#pragma once
/// What a window takes from the display that it is on.

#include <SFML/System/Vector2.hpp>

namespace flipside::app {

/// The size of letters and controls that suits a window of that size, px, on this display.
[[nodiscard]] double scale_for(sf::Vector2u size);
/// Where a window of that size lies in the middle of this display, px.
[[nodiscard]] sf::Vector2i middle_for(sf::Vector2u size);

}  // namespace flipside::app
