/// A scene file that is edited while the window shows it.

#include <fstream>

#include "app/window_fixture.hpp"
#include "lab/files/assets.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {
namespace {

namespace fs = std::filesystem;

class EditedScene : public WindowTest {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-scene-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        write(with_balls(2));
        open((folder / "mine.json").string(), "split", "custom", {"--set", "box2d.substeps=3"});
        // Files keep the time of their last change to some milliseconds.
        window->wait("half a second", [](const Json& s) { return s["time"] > 0.5; });
    }
    void TearDown() override {
        WindowTest::TearDown();
        fs::remove_all(folder);
    }
    [[nodiscard]] static std::string with_balls(int count) {
        std::string balls;
        for (int i = 0; i < count; ++i)
            balls += std::string(i == 0 ? "" : ", ") + "{\"position\": [" + std::to_string(0.1 + 0.1 * i) +
                     ", 0.5], \"radius\": 0.02, \"mass\": 0.1, \"material\": \"steel\"}";
        return "{\"format\": \"flipside-scene/1\", \"name\": \"mine\", \"gravity\": [0, 0], "
               "\"bounds\": {\"min\": [0, 0], \"max\": [1, 1]}, "
               "\"materials\": {\"steel\": {\"restitution\": 1}}, \"parts\": [{\"name\": \"floor\", "
               "\"material\": \"steel\", \"shape\": {\"type\": \"segment\", \"a\": [0, 0.1], "
               "\"b\": [1, 0.1]}}], \"balls\": [" +
               balls + "]}";
    }
    void write(const std::string& text) const { std::ofstream(folder / "mine.json") << text; }

    fs::path folder;
};

TEST_F(EditedScene, IsShownAsItIsNow) {
    write(with_balls(3));
    const Json state =
        window->wait("a third ball", [](const Json& s) { return s["panes"][1]["balls"].size() == 3; });
    EXPECT_EQ(state["panes"][0]["balls"].size(), 3U);
    EXPECT_EQ(state["engines"][1]["settings"]["substeps"], "3");
    EXPECT_EQ(state["notice"], "");
}

TEST_F(EditedScene, KeepsTheOldOneWhileItIsFaulty) {
    write("{\"format\": \"flipside-scene/1\", \"balls\": 7}");
    const Json faulty = window->wait("the fault", [](const Json& s) { return s["notice"] != ""; });
    EXPECT_NE(faulty["notice"].get<std::string>().find("mine.json"), std::string::npos);
    EXPECT_EQ(faulty["panes"][0]["balls"].size(), 2U);
    const double time = faulty["time"];
    window->wait("time to go on", [&](const Json& s) { return s["time"] > time + 0.1; });
    fs::remove(folder / "mine.json");
    write(with_balls(4));
    const Json good =
        window->wait("the good one", [](const Json& s) { return s["panes"][0]["balls"].size() == 4; });
    EXPECT_EQ(good["notice"], "");
}

}  // namespace
}  // namespace flipside::app
