#pragma once
/// Where the card is: in a corner, out of the way of what is looked at, or where the user has moved it.

#include <optional>
#include <span>

#include "app/window/layout.hpp"
#include "world/vec2.hpp"

namespace flipside::app {

class CardPlace {
  public:
    /// For a card of that size, all in px of the window and the card within it. It stays in its corner of the
    /// panes as long as it covers none of `watched`, or no other corner is better; it never goes over the
    /// controls for that.
    Rect put(Vec2 size, const Rect& panes, const Rect& window, std::span<const Rect> watched);
    /// It stays there from now on.
    void move_to(Vec2 place) { moved_ = place; }
    [[nodiscard]] const Rect& place() const { return place_; }

  private:
    int corner_ = 0;
    std::optional<Vec2> moved_;
    Rect place_;
};

}  // namespace flipside::app
