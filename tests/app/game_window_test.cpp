/// A whole game in the real window: what is said on the table, how it ends, and what is kept of it.

#include <fstream>

#include "app/window/high_scores.hpp"
#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

namespace fs = std::filesystem;

/// A game of one ball, which scores at a bumper above the launcher and drains.
constexpr std::string_view short_scene = R"({
  "format": "flipside-scene/1", "name": "short", "bounds": {"min": [0, 0], "max": [1, 1]}, "gravity": [0, -2],
  "materials": {"bumper": {"kick": 1}},
  "parts": [{"name": "bumper", "material": "bumper", "shape": {"type": "circle", "center": [0.5, 0.8], "radius": 0.1}}],
  "launcher": {"position": [0.5, 0.2], "direction_deg": 90, "speed": [2, 3],
    "ball": {"radius": 0.02, "mass": 0.1}},
  "rules": {"balls": 1, "score": {"bumper": 700}, "tilt": {"nudges": 3, "seconds": 100},
            "end_bonus": {"points": {"bumper": 50}, "most_times": 2}}})";

class GameWindow : public WindowTest {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-game-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        home = name;
        std::ofstream(home / "short.json") << short_scene;
    }
    void TearDown() override {
        WindowTest::TearDown();
        fs::remove_all(home);
    }
    void start(const std::string& view = "split") {
        if (window) WindowTest::TearDown();
        window = std::make_unique<RealWindow>(
            std::vector<std::string>{(home / "short.json").string(), "--view", view}, home);
    }
    Json wait_for_end() {
        return window->wait("the end of the game", [](const Json& s) { return !s["game_end"].is_null(); });
    }
    [[nodiscard]] fs::path file() const { return home / "flipside" / "scores.json"; }

    fs::path home;
};

/// Where it charged faster, a frame more or less would miss the lanes of the pinball table.
TEST_F(GameWindow, ALaunchIsChargedInTwoSeconds) {
    start();
    window->xdotool("keydown space");
    const Json first = window->wait("a charge", [](const Json& s) { return s["charge"] > 0; });
    const Json later = window->wait("half a charge", [](const Json& s) { return s["charge"] >= 0.5; });
    window->xdotool("keyup space");
    const auto rise = [&](const char* of) { return later[of].get<double>() - first[of].get<double>(); };
    EXPECT_NEAR(rise("time") / rise("charge"), 2, 0.2);
}

TEST_F(GameWindow, AGameEndsWithACardAndSpaceBeginsAnother) {
    start();
    launch();
    const Json end = wait_for_end()["game_end"];
    ASSERT_EQ(end["scores"].size(), 2U);
    for (const Json& score : end["scores"]) {
        EXPECT_EQ(score["points"], 750);  // 700 and a bonus of 50
        EXPECT_EQ(score["best"], true);
        EXPECT_EQ(score["enters"], true);
    }
    EXPECT_NE(end["parted"], "");
    EXPECT_EQ(end["high"].size(), 2U);

    window->xdotool("keydown space");
    const Json again = window->wait("another game", [](const Json& s) { return s["game_end"].is_null(); });
    EXPECT_EQ(again["panes"][0]["score"], 0);
    EXPECT_EQ(again["charge"], 0);
    window->xdotool("keyup space");
    const Json waits = window->wait("half a second", [](const Json& s) { return s["time"] > 0.5; });
    EXPECT_EQ(waits["panes"][0]["launched"], 0);  // that press was for the new game alone
    launch();
    wait_for_end();
}

TEST_F(GameWindow, HighScoresAreKeptBetweenStarts) {
    start("single");
    launch();
    wait_for_end();
    ASSERT_EQ(load_high_scores(file()).size(), 1U);
    start("single");
    launch();
    const Json end = wait_for_end()["game_end"];
    EXPECT_EQ(end["high"].size(), 2U);
    const auto kept = load_high_scores(file());
    ASSERT_EQ(kept.size(), 2U);
    EXPECT_EQ(kept[0].scene, (home / "short.json").string());
    EXPECT_EQ(kept[0].engine, "custom");
    EXPECT_EQ(kept[0].score, 750);
}

TEST_F(GameWindow, AGameThatWasGoneBackInOrSlowedDownIsNoHighScore) {
    start("single");
    window->key("s");
    window->wait("slow motion", [](const Json& s) { return s["speed"] < 1; });
    launch();
    wait_for_balls();
    window->key("s");
    EXPECT_EQ(wait_for_end()["game_end"]["scores"][0]["enters"], false);
    window->key("space");
    window->wait("another game", [](const Json& s) { return s["game_end"].is_null(); });
    launch();
    window->wait("the bumper", [](const Json& s) { return s["panes"][0]["score"] > 0; });
    window->key("comma");
    window->wait("the past", [](const Json& s) { return s["in_past"] == true; });
    window->key("p");
    EXPECT_EQ(wait_for_end()["game_end"]["scores"][0]["enters"], false);
    EXPECT_FALSE(fs::exists(file()));
}

TEST_F(GameWindow, AnEndThatIsGoneBackToEntersNothingTwice) {
    start("single");
    launch();
    wait_for_end();
    window->key("Home");
    window->wait("the beginning", [](const Json& s) { return s["game_end"].is_null(); });
    window->key("End");
    EXPECT_EQ(wait_for_end()["game_end"]["high"].size(), 1U);
    EXPECT_EQ(load_high_scores(file()).size(), 1U);
}

TEST_F(GameWindow, TheTableTellsOfATiltBeforeItComes) {
    start("single");
    const auto caption = [](const Json& s) {
        return s["panes"][0]["caption"].is_null() ? "" : s["panes"][0]["caption"][0].get<std::string>();
    };
    launch();
    wait_for_balls();
    window->key("n");
    window->key("n");
    window->wait("the warning", [&](const Json& s) { return caption(s) == "Careful"; });
    // More than one, since the meter may have sunk by now.
    window->xdotool("key n n n");
    window->wait("the tilt", [&](const Json& s) { return caption(s) == "Tilt"; });
    wait_for_end();
}

TEST_F(GameWindow, AFileThatIsNoneIsLeftAlone) {
    fs::create_directories(file().parent_path());
    std::ofstream(file()) << R"({"format": "flipside-scores/1", "scores": [{"scene": "x"}]})";
    start("single");
    launch();
    const Json end = wait_for_end();
    EXPECT_NE(end["notice"].get<std::string>().find("/scores/0"), std::string::npos) << end["notice"];
    std::ifstream in(file());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(text, R"({"format": "flipside-scores/1", "scores": [{"scene": "x"}]})");
}

}  // namespace
}  // namespace flipside::app
