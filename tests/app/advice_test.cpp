#include "app/window/advice.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

/// A game of one ball, which is fired straight out of the table.
constexpr std::string_view short_game = R"({
  "format": "flipside-scene/1", "name": "short", "bounds": {"min": [0, 0], "max": [1, 1]}, "gravity": [0, -1],
  "materials": {"steel": {"restitution": 1}},
  "parts": [{"name": "wall", "material": "steel", "shape": {"type": "segment", "a": [0, 0.9], "b": [1, 0.9]}}],
  "launcher": {"position": [0.5, 0.2], "direction_deg": -90, "speed": [1, 1],
    "ball": {"radius": 0.02, "mass": 0.1, "material": "steel"}},
  "rules": {"balls": 1, "ball_save": 0, "tilt": {"nudges": 3, "seconds": 3}, "score": {}}})";

class Advice : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "flipside-advice-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        std::ofstream(folder / "short.json") << short_game;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    [[nodiscard]] Stage stage_of(View view) const {
        return {(folder / "short.json").string(), "custom", view, {}, {}};
    }
    /// Plays the ball of one run to its end.
    static void play(Stage& stage, std::size_t run) {
        EXPECT_TRUE(stage.runs()[run].press(control::Launch{}));
        for (int i = 0; i < 120; ++i) stage.step();
    }
    [[nodiscard]] static std::string in_pane(const Stage& stage, std::size_t run) {
        return in_words(advice(std::span(stage.runs()).subspan(run, 1), stage));
    }
    [[nodiscard]] static std::string in_words(const std::optional<CaptionWords>& words) {
        return words ? words->title + ": " + words->detail : "";
    }

    std::filesystem::path folder;
};

TEST_F(Advice, SaysWhoPlaysOnWhereOneGameIsOver) {
    Stage stage = stage_of(View::split);
    EXPECT_EQ(in_pane(stage, 0), "Ball 1 of 1: hold Space, and let go");
    play(stage, 0);
    EXPECT_EQ(in_pane(stage, 0), "Game over here: box2d plays on");
    EXPECT_EQ(in_pane(stage, 1), "Ball 1 of 1: hold Space, and let go");
    play(stage, 1);
    EXPECT_EQ(in_pane(stage, 0), "");
    EXPECT_EQ(in_pane(stage, 1), "");
}

TEST_F(Advice, OfAnEmptySceneSaysHowABallComesOntoIt) {
    constexpr std::string_view head =
        R"({"format": "flipside-scene/1", "name": "bare", "bounds": {"min": [0, 0], "max": [1, 1]}, )";
    std::ofstream(folder / "bare.json") << head << R"("parts": []})";
    std::ofstream(folder / "one.json") << head << R"("parts": [],
        "balls": [{"position": [0.5, 0.5], "radius": 0.1, "mass": 1}]})";
    const Stage bare((folder / "bare.json").string(), "custom", View::single, {}, {});
    EXPECT_EQ(in_pane(bare, 0), "No balls: Ctrl and a click add one");
    Stage one((folder / "one.json").string(), "custom", View::single, {}, {});
    one.clear();
    EXPECT_EQ(in_pane(one, 0), "No balls: R to restart");
}

TEST_F(Advice, SaysBothOnOneTable) {
    Stage stage = stage_of(View::overlay);
    play(stage, 1);
    EXPECT_EQ(in_words(advice(stage.runs(), stage)), "Game over for box2d: custom plays on");
}

}  // namespace
}  // namespace flipside::app
