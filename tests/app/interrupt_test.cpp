// SIGINT, SIGTERM and SIGHUP end every command within a second, also in the middle of a step that lasts for
// minutes, with exit code 1, one line, and whole files only.

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "places.hpp"

namespace flipside {
namespace {

namespace fs = std::filesystem;
using Watch = std::chrono::steady_clock;

double since(Watch::time_point begin) {
    return std::chrono::duration<double>(Watch::now() - begin).count();
}

/// Processor time that a process has used, s.
double cpu_seconds(pid_t process) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string word;
    double ticks = 0;
    for (int field = 1; field <= 15 && stat >> word; ++field)
        if (field >= 14) ticks += std::stod(word);
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

class Interrupt : public ::testing::Test {
  protected:
    void SetUp() override {
        char name[] = "/tmp/flipside-interrupt-XXXXXX";
        folder_ = mkdtemp(name);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

    /// Many balls packed into a pile in one narrow step: it takes every engine long.
    [[nodiscard]] std::string long_scene(int rows = 1100) const {
        std::string scene = file("rows-" + std::to_string(rows) + ".json");
        std::ofstream(scene)
            << R"({"format": "flipside-scene/1", "name": "long", "gravity": [0, -9.81],)"
            << R"("bounds": {"min": [-1, -1], "max": [11, 2000]}, "balls": [], "parts": [)"
            << R"({"name": "cup", "shape": {"type": "polyline", "points": [[0, 2000], [0, 0], [10, 0], [10, 2000]]}}],)"
            << R"("generate": [{"type": "rows", "of": "balls", "radius": 0.05, "mass": 1, "speed": 20,)"
            << R"("count": 90, "from": [0.2, 0.2], "step": [0.105, 0], "row_step": [0, 0.105], "rows": )"
            << rows << "}]}";
        return scene;
    }

    /// Starts the command, waits until it has worked for a while, and expects the signal to end it in time.
    void expect_ended(const std::vector<std::string>& arguments, int signal) const {
        const pid_t child = start(arguments);
        constexpr double worked = 1;
        const auto began = Watch::now();
        while (cpu_seconds(child) < worked && since(began) < 20 && waitpid(child, nullptr, WNOHANG) == 0)
            usleep(10'000);
        const auto sent = Watch::now();
        kill(child, signal);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child) << arguments[0] << " had ended before";
        EXPECT_LT(since(sent), 1) << arguments[0];
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << arguments[0] << ", status " << status;
        std::ifstream said(file("err"));
        std::string line, rest;
        std::getline(said, line);
        EXPECT_EQ(line, "flipside: interrupted") << arguments[0];
        EXPECT_FALSE(std::getline(said, rest)) << rest;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            EXPECT_NE(entry.path().extension(), ".part") << arguments[0];
    }

  private:
    [[nodiscard]] pid_t start(const std::vector<std::string>& arguments) const {
        std::vector<std::string> words{test::flipside_program};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> pointers;
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        const std::string err = file("err"), out = file("out");
        const pid_t child = fork();
        if (child != 0) return child;
        dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
        execv(test::flipside_program, pointers.data());
        _exit(127);
    }

    fs::path folder_;
};

TEST_F(Interrupt, EndsARunInTheMiddleOfAStep) {
    const std::string scene = long_scene();
    const std::vector<std::vector<std::string>> engines = {
        {"custom", "solver=simple"}, {"custom", "solver=continuous"}, {"box2d"}, {"reference"}};
    for (const auto& engine : engines)
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
            std::vector<std::string> arguments{
                "run",      scene,   "--engine",   engine[0],  "--dt",         "1",      "--seconds",
                "10000000", "--out", file("traj"), "--events", file("events"), "--save", file("state")};
            if (engine.size() > 1) arguments.insert(arguments.end(), {"--set", engine[1]});
            expect_ended(arguments, signal);
            EXPECT_FALSE(fs::exists(file("traj")) || fs::exists(file("events")) || fs::exists(file("state")));
        }
}

TEST_F(Interrupt, EndsEveryCommand) {
    const std::string scene = long_scene();
    const std::vector<std::vector<std::string>> commands = {
        {"check", long_scene(11'000)},
        {"compare", scene, "--seconds", "100", "--json", file("compare.json")},
        {"cases", "--json", file("cases.json")},
        {"pairs", "--json", file("pairs.json")},
        {"sweep", "--out", file("sweep")},
        {"report", "--out", file("report")}};
    for (const auto& command : commands) expect_ended(command, SIGTERM);
}

}  // namespace
}  // namespace flipside
