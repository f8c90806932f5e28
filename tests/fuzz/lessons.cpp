/// Lesson files, read; what they claim is measured where that is little work, and their statements are
/// evaluated, which must change nothing.

#include <algorithm>
#include <cmath>

#include "fuzz/oracle.hpp"
#include "fuzz/target.hpp"
#include "lab/lessons/claim.hpp"

namespace flipside::fuzz {

namespace {

/// The limits of lesson files are for people who wait; a fuzzer has thousands of them to try.
bool is_little_work(const lab::Claim& claim) {
    double ball_steps = 0;
    for (const lab::ClaimRun& run : claim.runs) {
        const auto balls = static_cast<double>(run.scene->balls.size());
        const auto parts = static_cast<double>(run.scene->parts.size());
        ball_steps += run.seconds / *run.on.dt * (1 + balls) * (1 + parts);
        if (run.against_reference || run.on.engine->name == "reference") return false;
    }
    return ball_steps < 2000;
}

}  // namespace

void run_input(std::string_view input) {
    set_subject("reader");
    lab::Lesson lesson;
    const bool read = accepted([&] {
        const CpuLimit limit(longest_answer);
        lesson = lab::parse_lesson(input, "input.json");
    });
    if (!read) return;
    if (lesson.question)
        require(lesson.question->right < lesson.question->answers.size(), "no answer is the right one");
    require(!lesson.engines.empty(), "a lesson has no engine to show");
    set_subject("claim");
    static_cast<void>(accepted([&] {
        const CpuLimit limit(longest_answer);
        for (const lab::ClaimRun& run : lesson.claim.runs) {
            require(run.seconds / *run.on.dt <= 1e6, "a run has no bound");
            require(run.from < run.seconds, "a run is over before its counts begin");
        }
        lab::Figures figures;
        if (is_little_work(lesson.claim)) figures = lab::measure(lesson.claim);
        figures.try_emplace("a.steps", 1);
        const lab::Figures before = figures;
        const auto verified = lab::verify(lesson.claim, figures, "input.json");
        require(verified.size() == lesson.claim.holds.size(), "a statement is left out");
        const auto same = [](const auto& a, const auto& b) {
            return a.first == b.first &&
                   (a.second == b.second || (std::isnan(a.second) && std::isnan(b.second)));
        };
        require(std::ranges::equal(figures, before, same), "a statement has changed a figure");
    }));
}

}  // namespace flipside::fuzz
