#pragma once
/// The mouse over the table: the wheel zooms, dragging moves, a double click fits.

#include <SFML/Window/Event.hpp>

#include "app/window/camera.hpp"
#include "app/window/layout.hpp"

namespace flipside::app {

class PaneMouse {
  public:
    /// All panes share `camera`. `now` is wall time, s.
    void process(const sf::Event& event, double now, const Layout& layout, Camera& camera);
    /// Whether the table is shown whole, and should be again when the pane's size changes.
    [[nodiscard]] bool fitted() const { return fitted_; }
    void fit() { fitted_ = true; }

  private:
    void press(Vec2 at, double now, const Layout& layout);

    static constexpr double double_click_seconds = 0.4, double_click_pixels = 6;

    bool fitted_ = true;
    bool dragging_ = false;
    Vec2 last_;               ///< px, of the window
    Vec2 pressed_;            ///< px, of the last press
    double pressed_at_ = -1;  ///< s
};

}  // namespace flipside::app
