#include "lab/bot/figures.hpp"

#include <sstream>

#include <gtest/gtest.h>

namespace flipside::lab::bot {
namespace {

Played game(long score, double seconds) {
    Played played;
    played.seed = 7;
    played.score = score;
    played.seconds = seconds;
    return played;
}

TEST(BotFigures, QuartilesLieBetweenTheValuesInOrder) {
    const Spread five = spread_of({50, 10, 30, 20, 40});
    EXPECT_EQ(five.quarter, 20);
    EXPECT_EQ(five.median, 30);
    EXPECT_EQ(five.three_quarters, 40);
    EXPECT_EQ(five.greatest, 50);
    EXPECT_EQ(spread_of({1, 2}).median, 1.5);
    EXPECT_EQ(spread_of({3}).three_quarters, 3);
}

TEST(BotFigures, CountsAddUpOverAllGames) {
    Played first = game(100, 60), second = game(300, 120);
    first.lost = 3;
    first.drained_after = {{"outlane", 2}, {"", 1}};
    first.longest_still = 4;
    second.finished = false;
    second.lost = 2;
    second.strays = 1;
    second.stuck = 2;
    second.searches = 3;
    second.drained_after = {{"outlane", 2}};
    const Played games[] = {first, second};
    const Figures figures = figures_of(games);
    EXPECT_EQ(figures.score.median, 200);
    EXPECT_EQ(figures.seconds.median, 90);
    EXPECT_EQ(figures.unfinished, 1U);
    EXPECT_EQ(figures.lost, 5);
    EXPECT_EQ(figures.strays, 1U);
    EXPECT_EQ(figures.stuck, 2);
    EXPECT_EQ(figures.searches, 3);
    EXPECT_EQ(figures.longest_still, 4);
    EXPECT_EQ(figures.drained_after, (std::map<std::string, int>{{"", 1}, {"outlane", 4}}));
}

TEST(BotFigures, EveryGameIsARow) {
    Played games[] = {game(100, 60.5), game(300, 120)};
    games[0].searches = 1;
    std::ostringstream out;
    write_games(out, games);
    EXPECT_EQ(out.str(), "0,7,100,60.5,yes,0,0,0,0,0,1,0\n1,7,300,120,yes,0,0,0,0,0,0,0\n");
}

}  // namespace
}  // namespace flipside::lab::bot
