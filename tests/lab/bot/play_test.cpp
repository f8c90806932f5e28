#include "lab/bot/play.hpp"

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/run.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab::bot {
namespace {

Request pinball_on(std::string_view name) {
    const auto scene = std::make_shared<const Scene>(load_scene(scene_file("pinball")));
    const Engine& engine = engine_named(name);
    return {scene, &engine, settings_for(engine, *scene)};
}

class BotPlays : public ::testing::TestWithParam<const char*> {};

TEST_P(BotPlays, TheSameGameWithTheSameSeed) {
    const Request request = pinball_on(GetParam());
    const Played once = play(request, 5), again = play(request, 5), other = play(request, 6);
    EXPECT_TRUE(once.finished);
    EXPECT_GT(once.score, 0);
    EXPECT_EQ(once.strays, 0U);
    EXPECT_GE(once.lost, request.scene->rules->balls);
    EXPECT_EQ(once.score, again.score);
    EXPECT_EQ(once.seconds, again.seconds);
    EXPECT_EQ(once.drained_after, again.drained_after);
    EXPECT_NE(std::pair(once.score, once.seconds), std::pair(other.score, other.seconds));
}

TEST_P(BotPlays, WhatItsScriptPlaysAgain) {
    const Request request = pinball_on(GetParam());
    const Played played = play(request, 11);
    Session session(request.scene, *request.engine, request.settings);
    const Timeline timeline(0, played.seconds, request.dt);
    run({&session, 1}, timeline, played.script, [](const Session&, std::uint64_t, double) {});
    EXPECT_EQ(session.game().score(), played.score);
    EXPECT_TRUE(session.game().over());
    EXPECT_EQ(session.game().lost(), played.lost);
}

INSTANTIATE_TEST_SUITE_P(OnEveryEngine, BotPlays, ::testing::Values("custom", "box2d"));

TEST(BotGames, FollowFromTheSeedOfTheFirst) {
    const Request request = pinball_on("custom");
    std::vector<std::size_t> told;
    const auto games = play(request, 20, 2, [&](std::size_t done) { told.push_back(done); });
    ASSERT_EQ(games.size(), 2U);
    EXPECT_EQ(told, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(games[1].seed, 21U);
    EXPECT_EQ(games[1].score, play(request, 21).score);
}

TEST(BotGames, AnEndlessOneIsLeftUnfinished) {
    Request request = pinball_on("custom");
    request.longest = 2;
    const Played played = play(request, 1);
    EXPECT_FALSE(played.finished);
    EXPECT_NEAR(played.seconds, 2, request.dt);
}

TEST(BotGames, TakeATableToPlayOn) {
    EXPECT_NO_THROW(require_playable(*pinball_on("custom").scene));
    EXPECT_THROW(require_playable(load_scene(scene_file("box"))), InputError);
    EXPECT_THROW(require_playable(load_scene(scene_file("toy"))), InputError);
}

}  // namespace
}  // namespace flipside::lab::bot
