#pragma once
/// Everything but the control column: headers, panes and plots, drawn the same into the window and into a
/// picture.

#include <vector>

#include "app/window/layout.hpp"
#include "app/window/stage.hpp"
#include "app/window/table_view.hpp"

namespace flipside::app {

/// Panes and headers that a view needs, in a window of this size.
[[nodiscard]] Layout layout_of(const Stage& stage, double width, double height, double scale, Column column);
/// Around a table that fills its pane, px on an ordinary display.
inline constexpr double pane_margin = 12;
/// What a scene wants to be seen of it.
[[nodiscard]] const Box& sight_of(const Scene& scene);

class Screen {
  public:
    explicit Screen(double scale) : lettering_(scale), canvas_(lettering_) {}

    /// `camera` is that of every pane. `scores` has one per run.
    void draw(sf::RenderTarget& target, const Stage& stage, const Layout& layout, const Camera& camera,
              const Look& look, const std::vector<long>& scores);
    [[nodiscard]] double scale() const { return lettering_.scale(); }

  private:
    void draw_pane(sf::RenderTarget& target, const Rect& place, std::span<const Run> runs,
                   const Camera& camera, const Look& look);

    Lettering lettering_;
    Canvas canvas_;
};

}  // namespace flipside::app
