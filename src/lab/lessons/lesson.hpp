#pragma once
/// A lesson: one idea, told in a text beside a table that shows it, with a question, and a claim that is
/// verified by running it, so that no lesson can become false. All of it is data: assets/lessons/NN-NAME.json
/// and NN-NAME.md; adding one needs no code.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/contenders/contender.hpp"
#include "world/engine.hpp"

namespace flipside::lab {

/// What is measured for a claim.
struct ClaimRun {
    std::string name;  ///< of its figures: NAME.steps
    std::shared_ptr<const Scene> scene;
    ContenderRequest on;             ///< with its step
    double seconds = 0, from = 0;    ///< s; counts are from `from` on
    bool against_reference = false;  ///< how far it is from the reference at the end
    bool trace = false;              ///< its first step is traced
    std::string compare_with;        ///< another run: which balls touch which parts when they begin
};

struct Claim {
    std::string says;
    std::vector<ClaimRun> runs;
    /// Of figures of the runs: "small.pair_tests_per_step == 45".
    std::vector<std::string> holds;
};

struct Question {
    std::string asks;
    std::vector<std::string> answers;
    std::size_t right = 0;
    std::string because;
};

enum class LessonView { single, split, overlay };

struct Lesson {
    std::string name;  ///< of its file, without the ending: "02-which-pairs"
    std::string title, idea;
    std::string text;  ///< Markdown
    std::shared_ptr<const Scene> scene;
    std::vector<ContenderRequest> engines;  ///< the first is shown; in the other views all are
    LessonView view = LessonView::single;
    std::vector<std::string> show;  ///< overlays, by the names of `flipside render --show`
    std::string plots;              ///< which ones stand below, by name; "": as they were
    bool inside = false;            ///< begins with the step bar open, paused
    bool paused = false;            ///< begins paused
    double speed = 1;               ///< simulated seconds per second
    std::string task;               ///< something to do
    std::optional<Question> question;
    Claim claim;
};

/// All but its name and its text. Throws InputError with file, JSON pointer, what is wrong and what is
/// allowed.
[[nodiscard]] Lesson parse_lesson(std::string_view text, const std::string& file);
/// The same of a file, with the Markdown file beside it.
[[nodiscard]] Lesson load_lesson(const std::filesystem::path& path);
/// In order. Throws InputError where the folder cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> lesson_files();
/// By name, by number ("2") or by path. Throws InputError that lists the known ones.
[[nodiscard]] std::filesystem::path lesson_file(const std::string& name);

}  // namespace flipside::lab
