#pragma once
/// Dear ImGui in an SFML window: feeds it size, time and input, and draws it with OpenGL 2.

#include <deque>

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

    void process(const sf::Event& event);
    void begin_frame(double seconds);
    void end_frame();

    [[nodiscard]] bool wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
    [[nodiscard]] bool wants_text() const { return ImGui::GetIO().WantTextInput; }

  private:
    sf::RenderWindow& window_;
    std::deque<sf::Event> mouse_;  ///< moves and buttons that ImGui has not seen yet
};

}  // namespace flipside::app
