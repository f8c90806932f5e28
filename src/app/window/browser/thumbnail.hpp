#pragma once
/// A small picture of a scene at its start, drawn as the table is.

#include <memory>

#include <SFML/Graphics/Texture.hpp>

#include "app/window/lettering.hpp"
#include "world/scene.hpp"

namespace flipside::app {

/// Of so many pixels. Throws std::runtime_error where none can be had, InputError where no engine takes the
/// scene.
[[nodiscard]] std::shared_ptr<const sf::Texture> thumbnail_of(const std::shared_ptr<const Scene>& scene,
                                                              const Lettering& lettering, unsigned width,
                                                              unsigned height);

}  // namespace flipside::app
