// What is abandoned when a signal ends the program.

#include "lab/process/unfinished.hpp"

#include <cerrno>
#include <csignal>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace flipside::lab {
namespace {

namespace fs = std::filesystem;

/// A process group of its own that waits for a signal.
pid_t start_waiting() {
    const pid_t id = fork();
    if (id == 0) {
        setpgid(0, 0);
        for (;;) pause();
    }
    setpgid(id, id);
    return id;
}

TEST(Unfinished, ChildHasEndedBeforeFilesAreRemoved) {
    // Until it has been waited for, what a killed child was opening may still appear.
    pid_t id = 0;
    const UnfinishedChild child([&] { return id = start_waiting(); });
    ASSERT_GT(id, 0);
    abandon_unfinished();
    EXPECT_EQ(kill(id, 0), -1);
    EXPECT_EQ(errno, ESRCH);
}

TEST(Unfinished, FilesThatAreNotWholeAreRemoved) {
    const fs::path folder = fs::temp_directory_path() / ("flipside-unfinished-" + std::to_string(getpid()));
    fs::create_directories(folder);
    const fs::path unfinished = folder / "unfinished", whole = folder / "whole";
    const auto create = [](const fs::path& file) { fclose(fopen(file.c_str(), "w")); };
    {
        const UnfinishedFile noted(whole);
        create(whole);
    }
    const UnfinishedFile noted(unfinished);
    create(unfinished);
    abandon_unfinished();
    EXPECT_FALSE(fs::exists(unfinished));
    EXPECT_TRUE(fs::exists(whole));
    fs::remove_all(folder);
}

}  // namespace
}  // namespace flipside::lab
