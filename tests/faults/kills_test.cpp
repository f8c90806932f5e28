// Sweeps and reports that are killed or interrupted at random moments, and taken up again until they are
// done: what they leave is whole, and what they end with is what an undisturbed one ends with.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "in_small.hpp"
#include "places.hpp"
#include "scenarios.hpp"

namespace flipside::faults {
namespace {

namespace fs = std::filesystem;

/// FLIPSIDE_KILLS=N asks for more than fits into a test.
int kills_wanted(int usual) {
    const char* const wish = std::getenv("FLIPSIDE_KILLS");
    if (wish != nullptr) return std::atoi(wish);
    return flipside::test::in_small ? (usual + 1) / 2 : usual;
}

class Kills : public ::testing::Test {
  protected:
    fs::path base = fs::temp_directory_path() / ("flipside-kills-" + std::to_string(getpid()));
    fs::path now = base / "now";
    std::mt19937 dice{std::random_device{}()};

    void TearDown() override { fs::remove_all(base); }

    /// An undisturbed run, and how long it takes, s.
    std::pair<Contents, double> undisturbed(const std::vector<std::string>& command) const {
        fs::create_directories(base / "whole");
        const auto begin = std::chrono::steady_clock::now();
        const Ended ended = Child(command, base / "whole").wait(600);
        EXPECT_EQ(ended.code, 0) << ended.err;
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        return {contents_of(base / "whole"), taken.count()};
    }

    void remove_temporary() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(now))
            if (entry.path().extension() == ".part") found.push_back(entry.path());
        for (const fs::path& file : found) fs::remove(file);
    }

    /// Starts the command, sends it the signal at a random moment, and looks at what is there. Whether it was
    /// done before.
    bool disturb(const std::vector<std::string>& command, int signal, double longest, const Contents& whole) {
        const double seconds = std::uniform_real_distribution<double>(0, longest)(dice);
        Child child(command, now);
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        child.signal(signal);
        const Ended ended = child.wait(60);
        if (signal == SIGKILL) {
            EXPECT_TRUE(ended.code == -SIGKILL || ended.code == 0) << ended.code << ": " << ended.err;
            remove_temporary();  // which nobody else could
        } else {
            // Before the signal is caught nothing has been written.
            EXPECT_EQ(ended.code == -signal ? "" : unclear_end(ended, false), "") << ended.code;
        }
        EXPECT_EQ(half_files(contents_of(now), {}, whole), "")
            << "after " << seconds << " s, signal " << signal;
        return ended.code == 0;
    }

    void expect_the_same_after_kills(const std::vector<std::string>& command, int usual) {
        const auto [whole, taken] = undisturbed(command);
        int kills = 0, rounds = 0;
        const int signals[] = {SIGKILL, SIGINT, SIGKILL, SIGTERM};
        for (const int wanted = kills_wanted(usual); kills < wanted; ++rounds) {
            fs::remove_all(now);
            fs::create_directories(now);
            // What is done before each kill stays done, so this ends.
            constexpr int most = 20;
            for (int i = 0; i < most && kills < wanted; ++i) {
                if (disturb(command, signals[kills % 4], 0.7 * taken, whole)) break;
                ++kills;
            }
            const Ended ended = Child(command, now).wait(600);
            EXPECT_EQ(ended.code, 0) << ended.err;
            EXPECT_EQ(ended.err, "");
            EXPECT_TRUE(contents_of(now) == whole);
        }
        std::cout << kills << " kills in " << rounds << " rounds; undisturbed it takes " << taken << " s\n";
    }
};

TEST_F(Kills, OfASweepChangeNothing) {
    expect_the_same_after_kills({test::flipside_program, "sweep", "drop", "--contenders",
                                 "box2d,custom-continuous", "--finest", "60", "--quick", "--out", "sweep"},
                                12);
}

TEST_F(Kills, OfAReportChangeNothing) {
    expect_the_same_after_kills({test::tiny_report, "report"}, 1);
}

}  // namespace
}  // namespace flipside::faults
