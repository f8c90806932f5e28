#pragma once
/// What a window takes from the display that it is on.

#include <SFML/System/Vector2.hpp>

namespace flipside::app {

/// The size of letters and controls in a window of that size, px, on this display: the one that is wanted, as
/// far as the window has room for it, or, where that is 0, the one that suits.
[[nodiscard]] double scale_for(sf::Vector2u size, double wanted);
/// Where a window of that size lies in the middle of this display, px.
[[nodiscard]] sf::Vector2i middle_for(sf::Vector2u size);

}  // namespace flipside::app
