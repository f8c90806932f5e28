#include "app/window/high_scores.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "world/input_error.hpp"

namespace flipside::app {
namespace {

namespace fs = std::filesystem;

HighScore scored(long points, const std::string& scene = "pinball") {
    return {scene, "custom", points, "2026-11-24"};
}

class HighScoresFile : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-scores-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        file = folder / "state" / "scores.json";
    }
    void TearDown() override { fs::remove_all(folder); }
    void write(const std::string& text) const {
        fs::create_directories(file.parent_path());
        std::ofstream(file) << text;
    }

    fs::path folder, file;
};

TEST_F(HighScoresFile, KeepsTheBestOfEachSceneInOrder) {
    HighScores scores(file);
    for (const long points : {300L, 100L, 500L, 200L, 400L}) EXPECT_GT(scores.enter(scored(points)), 0U);
    EXPECT_EQ(scores.enter(scored(50)), 0U);
    EXPECT_EQ(scores.enter(scored(0, "toy")), 0U);
    EXPECT_EQ(scores.enter(scored(50, "toy")), 1U);
    EXPECT_EQ(scores.enter(scored(300)), 4U);  // after the one that was there
    const auto best = scores.of("pinball");
    ASSERT_EQ(best.size(), HighScores::most);
    EXPECT_EQ(best.front().score, 500);
    EXPECT_EQ(best.back().score, 200);
    EXPECT_EQ(HighScores(file).of("pinball"), best);
    EXPECT_EQ(HighScores(file).of("toy").size(), 1U);
}

TEST_F(HighScoresFile, WhatAnotherWindowWroteStays) {
    HighScores one(file), other(file);
    one.enter(scored(100));
    other.enter(scored(200));
    one.enter(scored(300));
    EXPECT_EQ(HighScores(file).of("pinball").size(), 3U);
}

TEST_F(HighScoresFile, WithoutAFileTheyLastUntilTheEnd) {
    HighScores scores(std::nullopt);
    EXPECT_EQ(scores.enter(scored(100)), 1U);
    EXPECT_EQ(scores.of("pinball").size(), 1U);
    EXPECT_TRUE(scores.trouble().empty());
}

TEST_F(HighScoresFile, AFileThatIsNoGoodIsNamedAndLeftAlone) {
    for (
        const char* bad :
        {"", "[]", R"({"format": "flipside-scores/2", "scores": []})",
         R"({"format": "flipside-scores/1", "scores": [{"scene": "a", "engine": "b", "score": 0, "date": "2026-11-24"}]})",
         R"({"format": "flipside-scores/1", "scores": [{"scene": "a", "engine": "b", "score": 1, "date": "today"}]})",
         R"({"format": "flipside-scores/1", "scores": [], "more": 1})"}) {
        write(bad);
        EXPECT_THROW(static_cast<void>(load_high_scores(file)), InputError) << bad;
        HighScores scores(file);
        EXPECT_NE(scores.trouble().find(file.string()), std::string::npos) << scores.trouble();
        scores.enter(scored(100));
        std::ifstream in(file);
        EXPECT_EQ((std::string{std::istreambuf_iterator<char>(in), {}}), bad);
    }
}

TEST_F(HighScoresFile, WhereNothingCanBeWrittenItSaysSo) {
    std::ofstream(folder / "state") << "no folder";
    HighScores scores(file);
    EXPECT_EQ(scores.enter(scored(100)), 1U);
    EXPECT_NE(scores.trouble().find("not kept"), std::string::npos) << scores.trouble();
}

}  // namespace
}  // namespace flipside::app
