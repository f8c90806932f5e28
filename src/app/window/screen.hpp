#pragma once
/// Everything but the control column: headers, panes and plots, drawn the same into the window and into a
/// picture.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/window/game_end.hpp"
#include "app/window/layout.hpp"
#include "app/window/microscope.hpp"
#include "app/window/playfield/ground.hpp"
#include "app/window/plots.hpp"
#include "app/window/stage.hpp"
#include "app/window/table_view.hpp"

namespace flipside::app {

/// Panes and headers that a view needs, in a window of this size.
[[nodiscard]] Layout layout_of(const Stage& stage, double width, double height, double scale, Column column,
                               bool step_bar = false, double strip = 0);
/// Around a table that fills its pane, px on an ordinary display.
inline constexpr double pane_margin = 12;

/// Figures of the window itself that go with the stage.
struct Readings {
    std::vector<long> scores;  ///< one per run, as shown
    double asked = 1;          ///< simulated seconds per second that were due
    double reached = 1;        ///< and that the engines made
    bool paused = false;
    double speed = 1;       ///< simulated seconds per second
    double past = 0;        ///< how far the moment on show lies back, s
    std::string slow = {};  ///< what makes all wait, and what can be done; "" where nothing does
    PlotChoice plots = PlotChoice::distance_and_energy;
    Vec2 mouse{-1, -1};            ///< px
    const GameEnd* end = nullptr;  ///< of the game, once it is over on all runs
};

class Screen {
  public:
    explicit Screen(double scale) : lettering_(scale), canvas_(lettering_) {}

    /// `camera` is that of every pane. Where a step is looked into, `inside` says what to show of it.
    void draw(sf::RenderTarget& target, const Stage& stage, const Layout& layout, const Camera& camera,
              const Look& look, const Readings& readings, const Microscope* inside = nullptr);
    /// Where the step of each run stands in its header, as drawn last.
    [[nodiscard]] std::span<const std::optional<Rect>> steps() const { return steps_; }
    /// For what else is drawn into the window.
    [[nodiscard]] Canvas& canvas() { return canvas_; }
    [[nodiscard]] double scale() const { return lettering_.scale(); }

  private:
    void draw_pane(sf::RenderTarget& target, const Stage& stage, const Rect& place, std::span<const Run> runs,
                   const Camera& camera, const Look& look, const Microscope* inside);
    void draw_ground(sf::RenderTarget& target, const Camera& camera, const Run& run, const Look& look,
                     bool dimmed);
    void draw_links_of(std::span<const Run> runs, const Camera& camera);
    void draw_words(const Stage& stage, const Rect& place, std::span<const Run> runs, const Look& look);
    void draw_pace(const Rect& place, double right, const Readings& readings);
    void draw_halt(const Stage& stage, const Rect& place, const Run& run, bool alone);

    Lettering lettering_;
    Canvas canvas_;
    Ground ground_;
    std::vector<std::optional<Rect>> steps_;
};

}  // namespace flipside::app
