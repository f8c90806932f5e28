#pragma once
/// How a pane is drawn into: clipped to its rectangle, with its top left corner as the origin.

#include <SFML/Graphics/RenderTarget.hpp>

#include "app/window/layout.hpp"

namespace flipside::app {

[[nodiscard]] inline sf::View view_of_pane(const sf::RenderTarget& target, const Rect& place) {
    const auto f = [](double v) { return static_cast<float>(v); };
    const sf::Vector2f all(target.getSize());
    sf::View view({0, 0, f(place.width), f(place.height)});
    view.setViewport(
        {f(place.x) / all.x, f(place.y) / all.y, f(place.width) / all.x, f(place.height) / all.y});
    return view;
}

}  // namespace flipside::app
