#pragma once
/// The card beside the table.

#include <span>

#include "app/window/card.hpp"
#include "app/window/card_place.hpp"
#include "app/window/controls.hpp"

namespace flipside::app {

/// Draws it where `place` puts it, out of the way of `watched` (px of the window); it can be moved. Notes
/// where it is. False once the user has closed it.
bool draw_card(const Card& card, const Stage& stage, const Layout& layout, std::span<const Rect> watched,
               CardPlace& place, ControlPlaces& places);

}  // namespace flipside::app
