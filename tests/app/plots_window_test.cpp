/// The plots in the real window: which ones, and what is exported of them.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class PlotsWindow : public WindowTest {};

TEST_F(PlotsWindow, AKeyGoesThroughThemAndAnotherSavesThem) {
    open("drop");
    window->wait("some time", [](const Json& s) { return s["time"] > 0.3; });
    const Json paused = pause();
    EXPECT_EQ(paused["plots"], "Distance and energy");
    for (const char* name : {"Distance and cost", "Tests and cost", "All four", "Distance", "Energy",
                             "Cost per step", "Tests per step"}) {
        window->key("g");
        window->wait(name, [&](const Json& s) { return s["plots"] == name; });
    }
    window->key("F11");
    const Json saved =
        window->wait("the files", [](const Json& s) { return !s["last_export"].get<std::string>().empty(); });
    const std::filesystem::path csv = saved["last_export"].get<std::string>();
    std::ifstream in(csv);
    std::string line;
    std::getline(in, line);
    EXPECT_TRUE(line.starts_with("contender,engine,time_s,cpu_s,"));
    int rows = 0;
    while (std::getline(in, line)) ++rows;
    EXPECT_EQ(rows, paused["panes"][0]["steps"].get<int>() + paused["panes"][1]["steps"].get<int>());
    sf::Image image;
    ASSERT_TRUE(image.loadFromFile(std::filesystem::path(csv).replace_extension(".png").string()));
    const Json strip = saved["layout"]["strip"];
    EXPECT_EQ(image.getSize().x, strip[2].get<unsigned>());
    EXPECT_EQ(image.getSize().y, strip[3].get<unsigned>());
}

TEST_F(PlotsWindow, AreChosenByClicks) {
    open("drop");
    click("Plots");
    const Json list =
        window->wait("the list", [](const Json& s) { return s["controls"].contains("Plots Cost per step"); });
    window->click(list["controls"]["Plots Cost per step"]);
    window->wait("the plot", [](const Json& s) { return s["plots"] == "Cost per step"; });
}

TEST_F(PlotsWindow, TheirUpperEdgeIsDraggedWithinBoundsAndComesBack) {
    open("drop", "split", "custom", {"--width", "1280", "--height", "800", "--scale", "1"});
    Json state = settled();
    EXPECT_EQ(state["layout"]["strip"][3], 120);
    const auto drag_to = [&](double y) {
        const Json edge = state["controls"]["Edge of the plots"];
        const auto point = [](double px, double py) {
            return "mousemove " + std::to_string(std::lround(px)) + ' ' + std::to_string(std::lround(py)) +
                   ' ';
        };
        const double x = edge[0].get<double>() + 40;
        window->xdotool(point(x, edge[1].get<double>() + 0.5 * edge[3].get<double>()) + "mousedown 1");
        for (const double step : {0.5, 1.0})
            window->xdotool(point(x, edge[1].get<double>() + step * (y - edge[1].get<double>())));
        state = settled();
        window->xdotool("mouseup 1");
        state = settled();
    };
    const Json center = state["center"];
    drag_to(550);
    EXPECT_NEAR(state["layout"]["strip"][3].get<double>(), 240, 12);
    EXPECT_NEAR(state["layout"]["strip"][1].get<double>(), 553, 12);
    EXPECT_LT(state["layout"]["panes"][0][3], 500);
    EXPECT_EQ(state["center"], center);
    drag_to(10);
    EXPECT_EQ(state["layout"]["strip"][3], 360);
    drag_to(795);
    EXPECT_EQ(state["layout"]["strip"][3], 80);
    window->click(state["controls"]["Edge of the plots"], 2);
    window->wait("the usual height", [](const Json& s) { return s["layout"]["strip"][3] == 120; });
}

}  // namespace
}  // namespace flipside::app
