#pragma once
/// Runs the real executable, as a shell would, in a folder of its own.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "places.hpp"

namespace flipside::app {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

using Rows = std::vector<std::map<std::string, std::string>>;

/// Fields by the names in the first line. No field here has quotes.
inline Rows rows_of(const fs::path& csv) {
    const auto fields = [](const std::string& line) {
        std::vector<std::string> all(1);
        for (const char c : line) {
            if (c == ',')
                all.emplace_back();
            else
                all.back() += c;
        }
        return all;
    };
    std::ifstream in(csv);
    std::string line;
    std::getline(in, line);
    const auto names = fields(line);
    Rows rows;
    while (std::getline(in, line)) {
        const auto values = fields(line);
        EXPECT_EQ(values.size(), names.size()) << line;
        rows.emplace_back();
        for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) rows.back()[names[i]] = values[i];
    }
    return rows;
}

class CommandLine : public ::testing::Test {
  protected:
    struct Result {
        int code;
        std::string out, err;
    };
    fs::path folder = fs::temp_directory_path() / ("flipside-cli-" + std::to_string(getpid()));

    void SetUp() override { fs::create_directory(folder); }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string file(const std::string& name) const { return (folder / name).string(); }

    std::string environment = "env -u DISPLAY";

    /// Words of a shell's line; `redirected` comes after all that is redirected here.
    [[nodiscard]] Result flipside(const std::string& arguments, const std::string& redirected = "") const {
        const std::string command = environment + " " + std::string(test::flipside_program) + " " +
                                    arguments + " > " + file("out") + " 2> " + file("err") + " < /dev/null " +
                                    redirected;
        const int status = std::system(command.c_str());
        Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(file("out")),
                      text_of(file("err"))};
        expect_no_commands(result.out, arguments);
        expect_no_commands(result.err, arguments);
        return result;
    }

    /// Nothing of what a terminal takes for a command: control characters but \n, DEL, C1, changes of
    /// direction.
    static void expect_no_commands(const std::string& text, const std::string& where) {
        for (const char c : text) EXPECT_TRUE((c >= ' ' || c < 0 || c == '\n') && c != 0x7f) << where;
        for (const char* bad : {"\u0080", "\u009b", "\u009f", "\u200e", "\u2028", "\u202e", "\u2066"})
            EXPECT_EQ(text.find(bad), std::string::npos) << where;
    }

    /// Ends with `code` and one line on stderr in which `words` are found.
    void expect_refused(const std::string& arguments, int code, const std::string& words) const {
        expect_refused(flipside(arguments), arguments, code, words);
    }
    static void expect_refused(const Result& result, const std::string& arguments, int code,
                               const std::string& words) {
        EXPECT_EQ(result.code, code) << arguments;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << arguments << ": " << result.err;
        EXPECT_NE(result.err.find(words), std::string::npos) << arguments << ": " << result.err;
        EXPECT_EQ(result.out, "") << arguments;
    }
    void expect_good(const std::string& arguments) const {
        const Result result = flipside(arguments);
        EXPECT_EQ(result.code, 0) << arguments << ": " << result.err;
    }
};

}  // namespace flipside::app
