/// Games saved in the real window.

#include <fstream>

#include "app/window_fixture.hpp"
#include "lab/replay/play.hpp"

namespace flipside::app {
namespace {

class ReplayWindow : public WindowTest {
  protected:
    /// Saves the game on show, in a pause; what was saved.
    lab::Replay save() {
        const std::string before = window->now()["last_game"];
        window->key("F5");
        saved = window->wait("a saved game", [&](const Json& s) { return s["last_game"] != before; });
        return lab::load_replay(saved["last_game"].get<std::string>());
    }
    /// Each run of it is the same to the bit, and ends as its pane shows it.
    void expect_same(const lab::Replay& replay) const {
        ASSERT_EQ(replay.runs.size(), saved["panes"].size());
        for (std::size_t i = 0; i < replay.runs.size(); ++i) {
            lab::ReplayPlayer player(replay, i);
            while (player.step()) {
            }
            EXPECT_FALSE(player.parting()) << replay.runs[i].name;
            EXPECT_EQ(player.session().game().score(), saved["panes"][i]["score"].get<long>());
            const auto balls = player.session().world().balls();
            ASSERT_EQ(balls.size(), saved["panes"][i]["balls"].size());
            for (std::size_t ball = 0; ball < balls.size(); ++ball)
                EXPECT_EQ(balls[ball].position.x, saved["panes"][i]["balls"][ball]["position"][0]);
        }
    }
    Json saved;
};

TEST_F(ReplayWindow, AGameByKeysReplaysToTheSameScore) {
    open();
    launch(0.8);
    wait_for_balls();
    for (const char* key : {"Left", "Right", "n", "Left"}) {
        window->xdotool(std::string("keydown ") + key + " sleep 0.2 keyup " + key);
    }
    window->wait("some time", [](const Json& s) { return s["time"] > 4; });
    pause();
    const lab::Replay game = save();
    EXPECT_NE(saved["notice"].get<std::string>().find(saved["last_game"].get<std::string>()),
              std::string::npos);
    EXPECT_EQ(saved["notice"].get<std::string>().find("/./"), std::string::npos);
    window->wait("it to go by itself", [](const Json& s) { return s["notice"] == ""; });
    EXPECT_GE(game.runs[0].moves.size(), 7U);
    expect_same(game);
    const auto first = saved["last_game"];
    click("Save this game");
    const Json again = window->wait("another", [&](const Json& s) { return s["last_game"] != first; });
    EXPECT_TRUE(std::filesystem::exists(first.get<std::string>()));
    EXPECT_TRUE(again["last_game"].get<std::string>().ends_with("game-2.flipside-replay"));
}

TEST_F(ReplayWindow, WhatWasChangedAndGoneBackOnIsInIt) {
    open();
    launch(0.8);
    wait_for_balls();
    window->wait("some time", [](const Json& s) { return s["time"] > 3; });
    const double end = pause()["time"];
    for (int i = 0; i < 20; ++i) window->key("comma");
    window->wait("the past", [&](const Json& s) { return s["time"] < end - 0.3; });
    window->key("n");
    window->key("p");
    window->wait("another course", [&](const Json& s) { return s["time"] > end + 0.5; });
    pause();
    window->key("Tab");
    window->key("p");
    window->wait("more", [&](const Json& s) { return s["time"] > end + 1.5; });
    pause();
    expect_same(save());
}

}  // namespace
}  // namespace flipside::app
