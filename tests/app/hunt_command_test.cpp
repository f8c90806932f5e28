/// `flipside hunt` as a program.

#include <chrono>

#include "command_line.hpp"
#include "places.hpp"

namespace flipside::app {
namespace {

constexpr const char* small_hunt = "hunt --engine custom --goal work --scenes 20 --length 0.2 --out ";

TEST_F(CommandLine, AHuntEndsWithItsBudget) {
    const auto began = std::chrono::steady_clock::now();
    const Result result = flipside(small_hunt + file("hunted") + " --seconds 2");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_LT(took.count(), 60);
    const auto rounds = std::distance(fs::directory_iterator(folder / "hunted/rounds"), {});
    EXPECT_GE(rounds, 1);
    const std::string again = "--rounds " + std::to_string(rounds);
    EXPECT_NE(result.out.find(again + " --scenes 20 in place of --seconds"), std::string::npos) << result.out;
    expect_good(small_hunt + file("again") + " " + again);
    for (const char* name : {"worst.json", "rounds.csv", "plan.txt"})
        EXPECT_EQ(text_of(folder / "hunted" / name), text_of(folder / "again" / name)) << name;
    expect_refused(small_hunt + file("shard") + " --seconds 1 --shard 1/2", 2, "--shard");
    EXPECT_FALSE(fs::exists(file("shard")));
}

TEST_F(CommandLine, WhatAHuntFoundIsShownAgain) {
    expect_good(small_hunt + file("hunted") + " --rounds 1");
    const std::string replay = "hunt --engine custom --goal work --replay " + file("hunted/worst.json");
    const Result shown = flipside(replay + " --length 0.2");
    EXPECT_EQ(shown.code, 0) << shown.err;
    EXPECT_NE(text_of(file("hunted/worst.json")).find("--length 0.2 --contender"), std::string::npos);
    // As the files of earlier hunts say it.
    EXPECT_EQ(flipside(replay + " --seconds 0.2").out, shown.out);
}

}  // namespace
}  // namespace flipside::app
