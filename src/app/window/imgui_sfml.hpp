#pragma once
/// Dear ImGui in an SFML window: feeds it size, time and input, and draws it with OpenGL 2.

#include <deque>
#include <vector>

#include <SFML/Graphics/RenderWindow.hpp>
#include <SFML/Window/Event.hpp>
#include <imgui.h>

namespace flipside::app {

class Imgui {
  public:
    /// The window must stay as long as this object. Throws std::runtime_error when there are no fonts.
    Imgui(sf::RenderWindow& window, double scale);
    ~Imgui();
    Imgui(const Imgui&) = delete;
    Imgui& operator=(const Imgui&) = delete;

    /// Between two frames.
    void set_scale(double scale);
    /// Keys then work the controls: arrows move among them, Space uses one, Enter types a value.
    void want_keys(bool wanted);
    void queue(const sf::Event& event) { waiting_.push_back(event); }
    /// Begins a frame with as many of the queued events as ImGui can tell apart in one. Returns those that it
    /// leaves to the table: all but what goes into a field or hits a control. What was pressed may have gone
    /// to either, so everybody sees releases.
    [[nodiscard]] std::vector<sf::Event> begin_frame(double seconds);
    void end_frame();

  private:
    sf::RenderWindow& window_;
    std::deque<sf::Event> waiting_;
    bool keys_wanted_ = false;
    bool focus_moves_ = false;  ///< in the last frame, perhaps
};

}  // namespace flipside::app
