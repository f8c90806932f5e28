#pragma once
/// Words beside the lines of a drawing: each on a patch that keeps it readable, and none over another.

#include <vector>

#include "app/window/canvas.hpp"
#include "app/window/layout.hpp"

namespace flipside::app {

class Labels {
  public:
    /// All stay within a pane of `size` px; nothing is written in its first `top` px.
    Labels(Canvas& canvas, Vec2 size, double top) : canvas_(canvas), size_(size), top_(top) {}

    /// Centred at `at`, px, or where there is room above or below. Call the weightiest first.
    void put(Vec2 at, std::string_view words, sf::Color color, Type type = Type::small);

    /// With its nearest edge `gap` px from `at`, in a direction on the screen.
    void put_beside(Vec2 at, Vec2 direction, double gap, std::string_view words, sf::Color color,
                    Type type = Type::small);

    /// Where they are, px.
    [[nodiscard]] const std::vector<Rect>& places() const { return places_; }

  private:
    [[nodiscard]] bool is_free(const Rect& place) const;

    Canvas& canvas_;
    Vec2 size_;
    double top_;
    std::vector<Rect> places_;
};

}  // namespace flipside::app
