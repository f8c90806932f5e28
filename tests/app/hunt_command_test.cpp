/// `flipside hunt` as a program.

#include "command_line.hpp"
#include "places.hpp"

namespace flipside::app {
namespace {

constexpr const char* small_hunt = "hunt --engine custom --goal work --scenes 20 --length 0.2 --out ";

TEST_F(CommandLine, ABudgetOfAHuntIsANumberOfRounds) {
    expect_good(small_hunt + file("hunted") + " --seconds 0.12");
    expect_good(small_hunt + file("again") + " --rounds 3");
    for (const char* name : {"worst.json", "rounds.csv", "plan.txt"})
        EXPECT_EQ(text_of(folder / "hunted" / name), text_of(folder / "again" / name)) << name;
    const auto rounds_of = [&](const std::string& options) {
        const std::string name = "by" + std::to_string(std::hash<std::string>{}(options));
        expect_good(small_hunt + file(name) + options);
        return std::distance(fs::directory_iterator(folder / name / "rounds"), {});
    };
    EXPECT_EQ(rounds_of(" --seconds 0.001"), 1);
    expect_refused(small_hunt + file("both") + " --seconds 50 --rounds 1", 2, "--rounds excludes --seconds");
    EXPECT_FALSE(fs::exists(file("both")));
}

TEST_F(CommandLine, WhatAHuntFoundIsShownAgain) {
    expect_good(small_hunt + file("hunted") + " --rounds 1");
    const std::string replay = "hunt --engine custom --goal work --replay " + file("hunted/worst.json");
    const Result shown = flipside(replay + " --length 0.2");
    EXPECT_EQ(shown.code, 0) << shown.err;
    EXPECT_NE(text_of(file("hunted/worst.json")).find("--length 0.2 --contender"), std::string::npos);
    for (const char* of_a_search : {"--scenes 3", "--rounds 3", "--seed 3", "--shard 1/2"})
        expect_refused(replay + ' ' + of_a_search, 2, "excludes --replay");
    // As the files of earlier hunts say it.
    EXPECT_EQ(flipside(replay + " --seconds 0.2").out, shown.out);
}

}  // namespace
}  // namespace flipside::app
