/// `flipside bot`: whole games from the command line.

#include "command_line.hpp"

namespace flipside::app {
namespace {

TEST_F(CommandLine, TheBotPlaysTheSameGamesEachTimeAndSaysWhatTheyComeTo) {
    const std::string command = "bot pinball --engine custom --games 2 --seed 9 --out ";
    const Result first = flipside(command + file("a.csv")), second = flipside(command + file("b.csv"));
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(first.out, second.out);
    for (const char* line : {"time ", "score ", "unfinished 0 of 2", "drained", "0 lost otherwise", "stuck"})
        EXPECT_NE(first.out.find(line), std::string::npos) << line << first.out;
    EXPECT_EQ(text_of(file("a.csv")), text_of(file("b.csv")));
    const Rows rows = rows_of(file("a.csv"));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[1].at("seed"), "10");
    EXPECT_EQ(rows[1].at("finished"), "yes");
    EXPECT_NE(rows[0].at("score"), rows[1].at("score"));
}

TEST_F(CommandLine, TheBotsGamesAreReplaysToTheBit) {
    const Result games = flipside("bot pinball --engine box2d --games 2 --seed 3 --out " + file("games.csv") +
                                  " --replays " + file("new/games"));
    ASSERT_EQ(games.code, 0) << games.err;
    for (const auto& row : rows_of(file("games.csv"))) {
        const Result replay =
            flipside("replay " + file("new/games/game-" + row.at("seed") + ".flipside-replay"));
        EXPECT_EQ(replay.code, 0) << replay.err;
        EXPECT_NE(replay.out.find(row.at("score")), std::string::npos) << replay.out;
    }
    expect_refused("bot pinball --engine custom --games 1 --replays " + file("games.csv"), 2, "games.csv");
    const std::string before = text_of(file("new/games/game-3.flipside-replay"));
    expect_refused("bot pinball --engine custom --games 2 --seed 2 --replays " + file("new/games"), 2,
                   "game-3.flipside-replay");
    EXPECT_EQ(text_of(file("new/games/game-3.flipside-replay")), before);
    expect_refused("bot pinball --engine custom --games 1 --out " + file("x") + " --replays " + file("x"), 2,
                   "which is written too");
    expect_refused("bot pinball --engine custom --games 1 --out " + file("x/game-1.flipside-replay") +
                       " --replays " + file("x"),
                   2, "game-1.flipside-replay");
    EXPECT_FALSE(fs::exists(file("x")));
    expect_refused("bot pinball --engine custom --games 1 --seed 9 --replays " + file("new/games") +
                       " --out " + file("new/games/game-9.flipside-replay"),
                   2, "game-9.flipside-replay");
}

TEST_F(CommandLine, TheBotNeedsATableToPlayOn) {
    expect_refused("bot box --engine custom", 2, "no game can be played");
}

}  // namespace
}  // namespace flipside::app
