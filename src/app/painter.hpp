#pragma once
/// Pictures of a stage without a window, drawn as the window draws it. Needs an X server.

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/RenderTexture.hpp>

#include "app/window/screen.hpp"

namespace flipside::app {

class Painter {
  public:
    /// Of that size, px, with letters of that scale. Throws std::runtime_error where there is no memory for
    /// it.
    Painter(unsigned width, unsigned height, double scale);

    [[nodiscard]] sf::Image paint(const Stage& stage, const Look& look);

  private:
    sf::RenderTexture picture_;
    Screen screen_;
};

}  // namespace flipside::app
