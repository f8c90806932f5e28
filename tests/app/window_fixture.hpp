#pragma once
/// What the tests of the real window share.

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include <SFML/Graphics/Image.hpp>
#include <gtest/gtest.h>

#include "app/real_window.hpp"

namespace flipside::app {

using Json = RealWindow::Json;

/// Opens the real window on a virtual display and works it.
class WindowTest : public testing::Test {
  protected:
    static void SetUpTestSuite() { display = std::make_unique<VirtualDisplay>(); }
    static void TearDownTestSuite() { display.reset(); }

    void open(const std::string& scene = "pinball", const std::string& view = "split",
              const std::string& engine = "custom", const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{scene, "--view", view, "--engine", engine};
        arguments.insert(arguments.end(), more.begin(), more.end());
        window = std::make_unique<RealWindow>(arguments);
    }
    void TearDown() override {
        if (!window) return;
        const auto folder = window->folder();
        window.reset();
        std::filesystem::remove_all(folder);
    }
    /// Holds Space until the launch is charged that far.
    void launch(double charge = 0.6) {
        window->xdotool("keydown space");
        window->wait("the charge", [&](const Json& s) { return s["charge"] >= charge; });
        window->xdotool("keyup space");
    }
    Json wait_for_balls() {
        return window->wait("a ball in every pane", [](const Json& s) {
            for (const Json& pane : s["panes"])
                if (pane["balls"].empty() || pane["launched"] < 1) return false;
            return true;
        });
    }
    Json pause() {
        window->key("p");
        return window->wait("the pause", [](const Json& s) { return s["paused"] == true; });
    }
    Json wait_for_view(const std::string& view) {
        return window->wait("view " + view, [&](const Json& s) { return s["view"] == view; });
    }
    void click(const std::string& control) {
        const Json state = scroll_to(control);
        if (!state["controls"].contains(control)) throw std::runtime_error(control + " is not to be seen");
        window->click(state["controls"][control]);
    }
    /// The state in which a control is to be seen: in this or any other tab as it stands, else with the wheel
    /// turned over it.
    Json scroll_to(const std::string& control) {
        Json state = settled();
        for (const bool turns : {false, true})
            for (const char* tab : {"", "Table", "See", "Engines", "Numbers", "Lesson"}) {
                if (*tab != '\0' && state["controls"].contains(tab)) {
                    window->click(state["controls"][tab]);
                    state = settled();
                }
                if (turns) turn_to(control, state);
                if (state["controls"].contains(control)) return state;
            }
        return state;
    }
    /// Turns the wheel over the panel, down to the end and up again, until the control is to be seen.
    void turn_to(const std::string& control, Json& state) {
        for (const char* wheel : {"5", "4"})  // down, up
            for (Json before; !state["controls"].contains(control) && state["controls"] != before;) {
                before = state["controls"];
                const Json panel = state["layout"]["panel"];
                window->xdotool("mousemove " + std::to_string(panel[0].get<int>() + panel[2].get<int>() / 2) +
                                ' ' + std::to_string(panel[1].get<int>() + panel[3].get<int>() / 2) +
                                " click " + wheel);
                state = settled();
            }
    }
    Json settled() { return window->settled(); }

    static inline std::unique_ptr<VirtualDisplay> display;
    std::unique_ptr<RealWindow> window;
};

inline double distance(const Json& a, const Json& b) {
    return std::hypot(a[0].get<double>() - b[0].get<double>(), a[1].get<double>() - b[1].get<double>());
}

/// How far apart two colours are, 0 to 765.
inline int difference(sf::Color a, sf::Color b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

/// Whether a pixel near the circle of that radius has about that colour.
inline bool ring_has(const sf::Image& image, const Json& center, double radius, sf::Color color) {
    for (double r = radius - 2.5; r <= radius + 1; r += 0.5)
        for (int i = 0; i < 64; ++i) {
            const double turn = i * 0.0981747704246810387;
            const auto x = static_cast<unsigned>(center[0].get<double>() + r * std::cos(turn));
            const auto y = static_cast<unsigned>(center[1].get<double>() + r * std::sin(turn));
            if (x < image.getSize().x && y < image.getSize().y &&
                difference(image.getPixel(x, y), color) < 60)
                return true;
        }
    return false;
}

}  // namespace flipside::app
