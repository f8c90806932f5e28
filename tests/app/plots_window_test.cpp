/// The plots in the real window: which ones, and what is exported of them.

#include <algorithm>
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
    for (const char* name :
         {"Distance and cost", "All four", "Distance", "Energy", "Cost per step", "Tests per step"}) {
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

}  // namespace
}  // namespace flipside::app
