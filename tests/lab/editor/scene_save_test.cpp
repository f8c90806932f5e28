#include "lab/editor/scene_save.hpp"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "lab/files/assets.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {
namespace {

namespace fs = std::filesystem;

class SceneSave : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-save-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        write("mine.json", "mine");
    }
    void TearDown() override { fs::remove_all(folder); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
    }

    fs::path folder;
};

TEST_F(SceneSave, OnlyItsOwnFileAsItWasIsWrittenOver) {
    const OwnFile own{folder / "mine.json", "mine"};
    EXPECT_EQ(obstacle_to(folder / "mine.json", own), SaveObstacle::none);
    EXPECT_EQ(obstacle_to(folder / "." / "mine.json", own), SaveObstacle::none);
    EXPECT_EQ(obstacle_to(folder / "new.json", own), SaveObstacle::none);
    EXPECT_EQ(obstacle_to(folder / "mine.json", {}), SaveObstacle::taken);
    write("other.json", "other");
    EXPECT_EQ(obstacle_to(folder / "other.json", own), SaveObstacle::taken);
    write("mine.json", "somebody else's");
    EXPECT_EQ(obstacle_to(folder / "mine.json", own), SaveObstacle::changed);
    fs::remove(folder / "mine.json");
    EXPECT_EQ(obstacle_to(folder / "mine.json", own), SaveObstacle::none);
    fs::create_symlink("nowhere", folder / "link.json");
    EXPECT_EQ(obstacle_to(folder / "link.json", own), SaveObstacle::taken);
}

TEST_F(SceneSave, WhatComesWithTheProgramStays) {
    const fs::path shipped = scene_file("drop");
    EXPECT_EQ(obstacle_to(shipped, OwnFile{shipped, read_file(shipped)}), SaveObstacle::shipped);
}

TEST_F(SceneSave, NamesAreFreeAndHaveAnEnding) {
    EXPECT_EQ(typed_file("a/b"), "a/b.json");
    EXPECT_EQ(typed_file("b.txt"), "b.txt");
    EXPECT_EQ(free_scene_file(folder, "new"), folder / "new.json");
    EXPECT_EQ(free_scene_file(folder, "mine"), folder / "mine-2.json");
}

}  // namespace
}  // namespace flipside::lab
