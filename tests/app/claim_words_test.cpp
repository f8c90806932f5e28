#include "app/window/claim_words.hpp"

#include <SFML/System/String.hpp>
#include <gtest/gtest.h>

#include "app/window/imgui_look.hpp"
#include "lab/lessons/lesson.hpp"

namespace flipside::app {
namespace {

TEST(ClaimWords, SayWhatIsMeasuredInWords) {
    EXPECT_EQ(claim_in_words("one_step.pair_tests == 2 * 25", true), "box tests = 2 × 25");
    EXPECT_EQ(claim_in_words("one_step.steps == 1 && exact.pair_tests_per_step <= 3", false),
              "steps (one step) = 1 and box tests per step (exact) ≤ 3");
    EXPECT_EQ(claim_in_words("abs(a.y0 - a.r0 - 0.2) < 1e-9", true),
              "|y of ball 0 − radius of ball 0 − 0.2| < 10⁻⁹");
    EXPECT_EQ(claim_in_words("abs(2 * (a.x0 - 1)) < (3)", true), "|2 × (x of ball 0 − 1)| < (3)");
    EXPECT_EQ(claim_in_words("shown.vx12^2 > 1.5e3", true), "velocity along x of ball 12² > 1.5·10³");
    EXPECT_EQ(claim_in_words("step.moves_in_broad_phase == 0", true), "balls moved in broad phase = 0");
}

TEST(ClaimWords, TellOnlyTheFiguresThatAStatementDoesNotGive) {
    using Lines = std::vector<std::string>;
    EXPECT_EQ(measured_in_words({"a.lost == 0 && a.steps == 3", true, {"a.lost = 0", "a.steps = 3"}}, true),
              Lines());
    EXPECT_EQ(measured_in_words({"a.deepest < 1e-9", true, {"a.deepest = 2.5e-10 m"}}, true),
              Lines{"deepest overlap = 2.5·10⁻¹⁰ m"});
    EXPECT_EQ(measured_in_words({"abs(0.1 * 9.81 - 0.981) < 0.01", true, {}}, true), Lines());
}

TEST(ClaimWords, OfNoLessonHaveNamesForComputing) {
    for (const auto& file : lab::lesson_files())
        for (const std::string& statement : lab::load_lesson(file).claim.holds) {
            const std::string words = claim_in_words(statement, false);
            EXPECT_EQ(words.find_first_of("_*&"), std::string::npos) << words;
            EXPECT_EQ(words.find("||"), std::string::npos) << words;
        }
}

TEST(ClaimWords, AndLessonsHaveLettersInTheWindow) {
    for (const auto& file : lab::lesson_files()) {
        const lab::Lesson lesson = lab::load_lesson(file);
        std::string all = lesson.text + lesson.task + lesson.claim.says;
        for (const std::string& statement : lesson.claim.holds) all += claim_in_words(statement, false);
        for (const std::uint32_t character : sf::String::fromUtf8(all.begin(), all.end()))
            EXPECT_TRUE(character == '\n' || is_lettered(character)) << file << ": " << std::hex << character;
    }
}

}  // namespace
}  // namespace flipside::app
