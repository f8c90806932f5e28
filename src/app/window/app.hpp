#pragma once
/// The window: reads keys and mouse, lets the stage run in time, and draws it.

#include <initializer_list>
#include <optional>
#include <set>
#include <vector>

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/RenderWindow.hpp>
#include <SFML/System/Clock.hpp>

#include "app/sound/live.hpp"
#include "app/window/accumulator.hpp"
#include "app/window/browser/scene_browser.hpp"
#include "app/window/card_place.hpp"
#include "app/window/editor/editor.hpp"
#include "app/window/editor/editor_panel.hpp"
#include "app/window/file_watch.hpp"
#include "app/window/game_end.hpp"
#include "app/window/gamepad.hpp"
#include "app/window/hand.hpp"
#include "app/window/imgui_sfml.hpp"
#include "app/window/kept.hpp"
#include "app/window/keys.hpp"
#include "app/window/lesson_tab.hpp"
#include "app/window/microscope.hpp"
#include "app/window/mouse.hpp"
#include "app/window/playfield/frame_budget.hpp"
#include "app/window/screen.hpp"
#include "app/window/window_report.hpp"

namespace flipside::app {

class App {
  public:
    explicit App(const PlayOptions& options);

    /// Until the window is closed.
    void run();

  private:
    void begin_where_it_ended();
    void process(const sf::Event& event);
    void press(Action action, sf::Keyboard::Key key, bool down);
    void read_pad();
    void perform(Action action, bool down);
    void act(Action action);
    void act_on_time(Action action);
    void act_inside(Action action);
    void act_on_window(Action action);
    void flip(Side side, Action action);
    void nudge(Vec2 velocity);
    void arrange();
    void set_scale();
    void change_scale(double by);
    void look_after_files();
    void keep();
    void drop_slowest();
    void close();
    void leave();
    void begin_edit();
    void begin_new_scene();
    void end_edit();
    void draw_edit();
    void arrange_edit();
    void browse();
    void draw_browser();
    void open_chosen(const std::string& scene);
    void look_after_draft();
    void let_keys_go();
    bool take_for_drawing(const sf::Event& event);
    [[nodiscard]] bool may_discard(const std::string& to_do);
    void forget_question();
    void advance(double seconds);
    void touch(const sf::Event& event);
    void inspect();
    [[nodiscard]] std::vector<Rect> places_of(Other subject) const;
    void draw();
    [[nodiscard]] std::string slow_in_words() const;
    void measure(double frame, double busy);
    void count_up(double seconds);
    void save_screenshot();
    void export_plots();
    void save_game();
    void look_after_game();
    bool play_again();
    [[nodiscard]] sf::Image picture() const;
    [[nodiscard]] std::filesystem::path free_name(const std::string& stem,
                                                  std::initializer_list<std::string_view> endings) const;
    [[nodiscard]] bool held(Action action) const;

    std::optional<Keeper> keeper_;
    Kept kept_;
    WindowControls controls_;
    Stage stage_;
    Microscope microscope_;
    Lessons lessons_;
    WindowState state_;
    std::filesystem::path screenshots_;
    std::optional<WindowReport> report_;

    sf::RenderWindow window_;
    double scale_;  ///< of letters and controls
    std::optional<Screen> screen_;
    Imgui imgui_;
    PaneMouse mouse_;
    Hand hand_;
    CardPlace card_place_;
    Editor editor_;
    EditorPanel editor_panel_;
    SceneBrowser browser_;
    std::string discarding_;  ///< what was asked for that would discard what is drawn, and that
    std::string question_;    ///< the notice that asks about it
    Camera camera_;
    Layout layout_;
    ControlPlaces places_;

    sound::Live sound_;
    sf::Clock clock_;
    Accumulator accumulator_;
    std::set<sf::Keyboard::Key> held_;
    Gamepad pad_;
    HighScores high_scores_;
    int entered_game_ = 0;        ///< Stage::games() of the last one that was entered
    int helped_game_ = 0;         ///< of the last one that slow motion or single steps helped
    std::vector<double> scores_;  ///< as shown: they count up to the true ones
    std::string shown_scene_;     ///< the one the camera was set for
    FileWatch scene_file_;        ///< of the scene on show
    double looked_after_ = 0;     ///< when files were last looked at, s
    bool screenshot_wanted_ = false;
    bool export_wanted_ = false;

    Load load_;
    FrameBudget budget_;
    struct {
        double seconds = 0, running = 0, busy = 0, physics = 0, simulated = 0, asked = 0;
        int frames = 0;
    } measured_;  ///< since the last whole second
};

}  // namespace flipside::app
