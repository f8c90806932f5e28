#pragma once
/// The window: reads keys and mouse, lets the stage run in time, and draws it.

#include <initializer_list>
#include <optional>
#include <set>
#include <vector>

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/RenderWindow.hpp>
#include <SFML/System/Clock.hpp>

#include "app/window/accumulator.hpp"
#include "app/window/imgui_sfml.hpp"
#include "app/window/keys.hpp"
#include "app/window/lesson_tab.hpp"
#include "app/window/microscope.hpp"
#include "app/window/mouse.hpp"
#include "app/window/screen.hpp"
#include "app/window/window_report.hpp"

namespace flipside::app {

class App {
  public:
    explicit App(const PlayOptions& options);

    /// Until the window is closed.
    void run();

  private:
    void process(const sf::Event& event);
    void press(Action action, sf::Keyboard::Key key, bool down);
    void act(Action action);
    void act_inside(Action action);
    void flip(Side side, Action action);
    void nudge(Vec2 velocity);
    void arrange();
    void advance(double seconds);
    void draw();
    void measure(double frame, double busy);
    void count_up(double seconds);
    void save_screenshot();
    void export_plots();
    [[nodiscard]] sf::Image picture() const;
    [[nodiscard]] std::filesystem::path free_name(const std::string& stem,
                                                  std::initializer_list<std::string_view> endings) const;
    [[nodiscard]] bool held(Action action) const;

    Stage stage_;
    Microscope microscope_;
    Lessons lessons_;
    WindowControls controls_;
    WindowState state_;
    std::filesystem::path screenshots_;
    std::optional<WindowReport> report_;

    sf::RenderWindow window_;
    Screen screen_;
    Imgui imgui_;
    PaneMouse mouse_;
    Camera camera_;
    Layout layout_;
    ControlPlaces places_;

    sf::Clock clock_;
    Accumulator accumulator_;
    std::set<sf::Keyboard::Key> held_;
    std::vector<double> scores_;  ///< as shown: they count up to the true ones
    std::string shown_scene_;     ///< the one the camera was set for
    bool screenshot_wanted_ = false;
    bool export_wanted_ = false;

    Load load_;
    struct {
        double seconds = 0, busy = 0, physics = 0, simulated = 0, asked = 0;
        int frames = 0;
    } measured_;  ///< since the last whole second
};

}  // namespace flipside::app
