/// The man page and the completions say what --help says.

#include <regex>
#include <set>

#include "command_line.hpp"

namespace flipside::app {
namespace {

/// Words alone, as they are read: no escapes of troff, no marks, no line ends.
std::string words_of(const std::string& text) {
    std::string words = std::regex_replace(text, std::regex(R"(\\f[BIR]|`|\\&)"), "");
    words = std::regex_replace(words, std::regex(R"(\\-)"), "-");
    return std::regex_replace(words, std::regex(R"(\s+)"), " ");
}

class Usage : public CommandLine {
  protected:
    /// The commands that --help lists.
    [[nodiscard]] std::vector<std::string> commands() const {
        const std::string help = flipside("--help").out;
        std::istringstream lines(help.substr(help.find("Subcommands:")));
        std::vector<std::string> names;
        const std::regex begins(R"(^  ([a-z]+) .*)");
        std::smatch match;
        for (std::string line; std::getline(lines, line);)
            if (std::regex_match(line, match, begins)) names.push_back(match[1]);
        EXPECT_GE(names.size(), 18U);
        return names;
    }
    static constexpr std::size_t column = 30;  ///< where --help's descriptions begin

    /// What --help of a command describes: "--engine" and its sentence.
    [[nodiscard]] std::map<std::string, std::string> options_in_help(const std::string& command) const {
        std::map<std::string, std::string> options;
        std::istringstream lines(flipside(command + " --help").out);
        const std::regex begins(R"(^  (?:-[a-z],)?(--[a-z-]+).*)"), goes_on(R"(^ {20,}(.*))");
        std::smatch match;
        std::string name;
        for (std::string line; std::getline(lines, line);) {
            if (std::regex_match(line, match, begins)) options[name = match[1]];
            if (name.empty()) continue;
            if (std::regex_match(line, match, goes_on))
                options[name] += match[1].str() + ' ';
            else if (line.size() > column && line[column - 1] == ' ')
                options[name] += line.substr(column) + ' ';
        }
        EXPECT_TRUE(options.contains("--help")) << command;
        return options;
    }
};

TEST_F(Usage, TheManPageHasEveryCommandAndOptionOfHelpInItsWords) {
    const std::string page = flipside("manual").out;
    for (const std::string& command : commands()) {
        const auto begin = page.find(".SS \"flipside " + command + "\"");
        ASSERT_NE(begin, std::string::npos) << command;
        const std::string section = words_of(page.substr(begin, page.find("\n.S", begin + 1) - begin));
        for (const auto& [option, sentence] : options_in_help(command)) {
            const bool named = section.find(option + '"') != std::string::npos ||
                               section.find(option + " \"") != std::string::npos;
            EXPECT_TRUE(named) << command << ' ' << option;
            std::string said = words_of(sentence);
            while (said.ends_with(' ')) said.pop_back();
            said = said.substr(said.find_first_not_of(' '));
            EXPECT_NE(section.find(said), std::string::npos) << command << ' ' << option << ": " << said;
        }
    }
}

TEST_F(Usage, TheManPageBearsTheVersion) {
    std::string version = flipside("--version").out;
    version.pop_back();
    EXPECT_NE(flipside("manual").out.find("\"flipside " + version + "\""), std::string::npos);
}

TEST_F(Usage, BashCompletesEveryCommandAndOptionOfHelp) {
    const std::string script = flipside("completion bash").out;
    const auto words_after = [&](const std::string& begin) {
        const auto at = script.find(begin);
        EXPECT_NE(at, std::string::npos) << begin;
        std::istringstream words(
            script.substr(at + begin.size(), script.find('\'', at + begin.size()) - at - begin.size()));
        return std::set<std::string>(std::istream_iterator<std::string>(words), {});
    };
    const std::set<std::string> completed = words_after("_flipside_commands='");
    for (const std::string& command : commands()) {
        EXPECT_TRUE(completed.contains(command)) << command;
        const std::set<std::string> options = words_after("        " + command + ") options='");
        for (const auto& [option, sentence] : options_in_help(command))
            EXPECT_TRUE(options.contains(option)) << command << ' ' << option;
    }
}

TEST_F(Usage, AnUnknownShellIsRefusedWithThoseThatAreKnown) {
    expect_refused("completion tcsh", 2, "bash");
    expect_refused("completion", 2, "shell");
}

}  // namespace
}  // namespace flipside::app
