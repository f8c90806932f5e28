#include "app/cli/commands.hpp"
#include "app/cli/display.hpp"
#include "app/cli/output.hpp"
#include "app/play.hpp"
#include "lab/lessons/claim.hpp"
#include "lab/lessons/lesson.hpp"
#include "world/printable.hpp"
#include "world/trace.hpp"

namespace flipside::app {

namespace {

struct LessonsOptions {
    std::string name;  ///< "" for all
    bool check = false;
};

std::vector<std::filesystem::path> chosen_files(const LessonsOptions& options) {
    if (options.name.empty()) return lab::lesson_files();
    return {lab::lesson_file(options.name)};
}

/// Whether all that the lesson claims holds.
bool check_lesson(const std::filesystem::path& file) {
    const lab::Lesson lesson = lab::load_lesson(file);
    const auto verified = verify(lesson.claim, measure(lesson.claim), file.string());
    const bool all = std::ranges::all_of(verified, &lab::Verified::holds);
    print("%-28s %s\n", printable(lesson.name).c_str(), all ? "holds" : "DOES NOT HOLD");
    print("    %s\n", printable(lesson.claim.says).c_str());
    for (const lab::Verified& one : verified) {
        std::string measured;
        for (const std::string& figure : one.measured) measured += (measured.empty() ? "" : ", ") + figure;
        print("    %s  %s   (%s)\n", one.holds ? "yes" : "NO ", printable(one.statement).c_str(),
              printable(measured).c_str());
    }
    finish_output();
    return all;
}

int check_lessons(const LessonsOptions& options) {
    const auto files = chosen_files(options);
    std::size_t failed = 0;
    for (const auto& file : files) failed += !check_lesson(file);
    print("\n%s, %zu %s not hold\n", counted(files.size(), "lesson").c_str(), failed,
          failed == 1 ? "does" : "do");
    return failed == 0 ? 0 : 1;
}

int list_lessons() {
    for (const auto& file : lab::lesson_files()) {
        const lab::Lesson lesson = lab::load_lesson(file);
        print("%-28s %s: %s\n", printable(lesson.name).c_str(), printable(lesson.title).c_str(),
              printable(lesson.idea).c_str());
    }
    return 0;
}

int open_lesson(const std::string& name) {
    PlayOptions options;
    options.lesson = lab::lesson_file(name);
    static_cast<void>(
        lab::load_lesson(*options.lesson));  // what is wrong with it is said without a display too
    require_display();
    return play(options);
}

}  // namespace

void add_lessons(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<LessonsOptions>();
    CLI::App& command = *program.add_subcommand(
        "lessons", "List the lessons, a line each; open one in the window; or verify what they claim");
    command.add_option("name", options->name, "A lesson's name or number, or the path of its file")
        ->type_name("LESSON");
    command.add_flag(
        "--check", options->check,
        "Make the runs behind every claim, and say whether it holds (exit 1 where one does not)");
    command.callback([options, &chosen] {
        chosen = [options] {
            if (options->check) return check_lessons(*options);
            return options->name.empty() ? list_lessons() : open_lesson(options->name);
        };
    });
}

}  // namespace flipside::app
