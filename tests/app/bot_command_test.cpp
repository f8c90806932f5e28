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

TEST_F(CommandLine, TheBotNeedsATableToPlayOn) {
    expect_refused("bot box --engine custom", 2, "no game can be played");
}

}  // namespace
}  // namespace flipside::app
