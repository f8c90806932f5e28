#include "lab/lessons/lesson.hpp"

#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lab/lessons/claim.hpp"
#include "places.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {
namespace {

namespace fs = std::filesystem;

TEST(Lessons, AllHoldWhatTheyClaim) {
    const auto files = lesson_files();
    EXPECT_EQ(files.size(), 20U);
    for (const fs::path& file : files) {
        SCOPED_TRACE(file.string());
        const Lesson lesson = load_lesson(file);
        for (const Verified& one : verify(lesson.claim, measure(lesson.claim), file.string()))
            EXPECT_TRUE(one.holds) << one.statement << "   (" << ::testing::PrintToString(one.measured)
                                   << ")";
    }
}

TEST(Lessons, TellOneIdeaInAShortText) {
    for (const fs::path& file : lesson_files()) {
        const Lesson lesson = load_lesson(file);
        EXPECT_TRUE(lesson.text.starts_with("# " + lesson.title + "\n")) << file;
        EXPECT_LT(lesson.text.size(), 1500U) << file;
        EXPECT_FALSE(lesson.task.empty()) << file;
        EXPECT_TRUE(lesson.question.has_value()) << file;
        EXPECT_TRUE(lesson.idea.ends_with('.')) << file;
    }
}

/// scripts/pictures.sh makes both.
TEST(Lessons, HaveAPictureEachAndAnIndexOfAll) {
    const fs::path folder = test::source("docs/lessons");
    std::ifstream in(folder / "README.md");
    const std::string index(std::istreambuf_iterator<char>(in), {});
    std::set<fs::path> pictures;
    std::size_t at = 0;
    for (const fs::path& file : lesson_files()) {
        const Lesson lesson = load_lesson(file);
        const fs::path picture = folder / (lesson.name + ".png");
        pictures.insert(picture);
        std::ifstream png(picture, std::ios::binary);
        std::string signature(8, ' ');
        EXPECT_TRUE(png.read(signature.data(), 8)) << picture;
        EXPECT_EQ(signature, "\x89PNG\r\n\x1a\n") << picture;
        const std::string number = lesson.name.substr(0, 2);
        const std::size_t entry = index.find("## " + number + " " + lesson.title + "\n\n" + lesson.idea +
                                             "\n\n![" + lesson.title + "](" + lesson.name + ".png)\n");
        ASSERT_NE(entry, std::string::npos) << lesson.name;
        EXPECT_GT(entry, at) << lesson.name;
        at = entry;
    }
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_TRUE(entry.path().extension() != ".png" || pictures.contains(entry.path())) << entry.path();
}

TEST(Lessons, AreFoundByNameNumberAndPath) {
    const fs::path second = lesson_files()[1];
    EXPECT_EQ(lesson_file("02-which-pairs"), second);
    EXPECT_EQ(lesson_file("which-pairs"), second);
    EXPECT_EQ(lesson_file("2"), second);
    EXPECT_EQ(lesson_file(second.string()), second);
    try {
        static_cast<void>(lesson_file("99"));
        FAIL() << "found";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("01-one-frame"), std::string::npos) << error.what();
    }
}

/// A lesson in a folder of its own, with parts of it replaced.
class LessonFile : public testing::Test {
  protected:
    fs::path folder = fs::temp_directory_path() / ("flipside-lesson-" + std::to_string(getpid()));
    std::string text = R"({"format": "flipside-lesson/1", "title": "T", "idea": "I.",
        "scene": {"format": "flipside-scene/1", "name": "fall", "bounds": {"min": [-9, -9], "max": [9, 9]},
                  "gravity": [0, -2], "balls": [{"position": [0, 0], "radius": 0.1, "mass": 1}], "parts": []},
        "engines": [{"engine": "custom", "set": {"solver": "simple"}}],
        "question": {"asks": "Q?", "answers": ["a", "b"], "right": 1, "because": "B."},
        "claim": {"says": "S.", "runs": {"one": {"engine": "custom", "seconds": 1, "dt": "1/60"}},
                  "holds": ["abs(one.y0 + 1) < 1e-12"]}})";

    void SetUp() override { fs::create_directory(folder); }
    void TearDown() override { fs::remove_all(folder); }
    void replace(const std::string& what, const std::string& by) {
        ASSERT_NE(text.find(what), std::string::npos) << what;
        text.replace(text.find(what), what.size(), by);
    }
    [[nodiscard]] fs::path write() const {
        std::ofstream(folder / "lesson.json") << text;
        std::ofstream(folder / "lesson.md") << "# T\n";
        return folder / "lesson.json";
    }
    [[nodiscard]] std::vector<Verified> check() const {
        const fs::path file = write();
        const Lesson lesson = load_lesson(file);
        return verify(lesson.claim, measure(lesson.claim), file.string());
    }
    /// Is refused with the file's name, the pointer and those words.
    void expect_refused(const std::string& pointer, const std::string& words) const {
        try {
            static_cast<void>(check());
            FAIL() << "taken: " << text;
        } catch (const InputError& error) {
            const std::string message = error.what();
            for (const std::string& part : {std::string("lesson.json"), pointer, words})
                EXPECT_NE(message.find(part), std::string::npos) << message;
        }
    }
};

TEST_F(LessonFile, SaysWhetherItsClaimHoldsAndWhatWasMeasured) {
    ASSERT_EQ(check().size(), 1U);
    EXPECT_TRUE(check()[0].holds);
    EXPECT_EQ(check()[0].measured, std::vector<std::string>{"one.y0 = -1 m"});
    replace("abs(one.y0 + 1) < 1e-12", "one.y0 > 0");
    EXPECT_FALSE(check()[0].holds);
}

TEST_F(LessonFile, OnlyComparisonsAreClaims) {
    replace(R"("holds": [)", R"("holds": ["one.y0 < 0", "one.y0 = 3", )");
    expect_refused("/claim/holds/1", "\"one.y0 = 3\": = is no comparison; == is; allowed are comparisons");
}

TEST_F(LessonFile, UnknownKeysAreRefused) {
    replace(R"("idea": "I.")", R"("idea": "I.", "colour": 3)");
    expect_refused("/colour", "");
}

TEST_F(LessonFile, UnknownEnginesAndSettingsAreRefusedByPlace) {
    replace(R"({"engine": "custom", "set": {"solver": "simple"}})", R"({"engine": "havok"})");
    expect_refused("/engines/0/engine", "custom");
    replace(R"({"engine": "havok"})", R"({"engine": "custom", "set": {"solver": "magic"}})");
    expect_refused("/engines/0/set/solver", "continuous");
}

TEST_F(LessonFile, AnEngineThatIsThereTwiceNeedsNamesAndStepsThatMeet) {
    const std::string once = R"({"engine": "custom", "set": {"solver": "simple"}})";
    replace(once, once + R"(, {"engine": "custom", "dt": "1/240"})");
    expect_refused("/engines/1", "a \"name\" of its own");
    replace(R"("dt": "1/240")", R"("dt": "1/240", "name": "fine")");
    const Lesson lesson = load_lesson(write());
    ASSERT_EQ(lesson.engines.size(), 2U);
    EXPECT_EQ(lesson.engines[1].name, "fine");
    EXPECT_EQ(lesson.engines[1].dt, 1.0 / 240);
    replace(R"("1/240")", R"("1/97")");
    expect_refused("/engines", "does not divide");
    replace(R"("1/97")", R"("a while")");
    expect_refused("/engines/1/dt", "is not allowed");
    replace(R"("a while")", R"("1/60")");
    replace(R"("fine")", R"("fi\u001b[2Jne")");
    expect_refused("/engines/1/name", "no name");
}

TEST_F(LessonFile, AnAnswerThatIsNotThereIsNotTheRightOne) {
    replace(R"("right": 1)", R"("right": 2)");
    expect_refused("/question/right", "0 to 1");
}

TEST_F(LessonFile, AFaultInItsSceneIsNamed) {
    replace(R"("radius": 0.1)", R"("radius": -0.1)");
    expect_refused("/scene", "radius");
}

TEST_F(LessonFile, AStatementThatIsNoneIsRefusedWithTheFiguresThereAre) {
    replace("abs(one.y0 + 1) < 1e-12", "one.colour == 1");
    expect_refused("/claim/holds/0", "one.impacts");
    replace("one.colour == 1", "1 +");
    expect_refused("/claim/holds/0", "");
}

/// What has a fault, where that is, and what the message says of it.
struct Fault {
    const char *what, *by, *pointer, *words;
};

class FaultyLesson : public LessonFile, public testing::WithParamInterface<Fault> {};

TEST_P(FaultyLesson, IsRefusedWithFilePointerAndReason) {
    const Fault& fault = GetParam();
    replace(fault.what, fault.by);
    expect_refused(fault.pointer, fault.words);
}

constexpr const char* one_run = R"("one": {"engine": "custom", "seconds": 1, "dt": "1/60"})";

INSTANTIATE_TEST_SUITE_P(
    OfEveryKind, FaultyLesson,
    testing::Values(
        // of form
        Fault{R"("flipside-lesson/1")", R"("flipside-lesson/9")", "/format", "flipside-lesson/1"},
        Fault{R"("title": "T",)", "", "", "title"}, Fault{R"("idea": "I.")", R"("idea": "")", "/idea", ""},
        Fault{R"("idea": "I.")", R"("idea": 7)", "/idea", "a text"},
        Fault{R"("idea": "I.")", R"("idea": "I.", "speed": -1)", "/speed", "0.01"},
        Fault{R"("idea": "I.")", R"("idea": "I.", "show": ["pairs", "ghosts"])", "/show/1", "hit-points"},
        Fault{R"("answers": ["a", "b"])", R"("answers": ["a"])", "/question/answers", "2"},
        Fault{R"("holds": ["abs(one.y0 + 1) < 1e-12"])", R"("holds": [])", "/claim/holds", "1"},
        // of what it names
        Fault{R"("engines": [{"engine": "custom")", R"("engines": [{"engine": "cus\u001btom")",
              "/engines/0/engine", "box2d"},
        Fault{R"({"solver": "simple"})", R"({"colour": "red"})", "/engines/0/set/colour", "solver"},
        Fault{R"({"solver": "simple"})", R"({"motion_iterations": -3})", "/engines/0/set/motion_iterations",
              "is not allowed"},
        Fault{R"("scene": {"format")", R"("scene": "no-such-scene", "question": {"format")", "", ""},
        Fault{R"("right": 1)", R"("right": 5)", "/question/right", "0 to 1"},
        Fault{R"("parts": [])", R"("parts": [{"name": "p", "shape": {"type": "blob"}}])", "/scene", "blob"},
        // of runs
        Fault{one_run, R"("one": {"engine": "none", "seconds": 1})", "/claim/runs/one/engine", "custom"},
        Fault{one_run, R"("one": {"engine": "custom", "seconds": 1, "scene": "nowhere"})",
              "/claim/runs/one/scene", "nowhere"},
        Fault{one_run, R"("one": {"engine": "custom", "seconds": 0})", "/claim/runs/one/seconds",
              "is 0; allowed: a number above 0, up to 3600"},
        Fault{one_run, R"("one": {"engine": "custom", "seconds": 1, "dt": "soon"})", "/claim/runs/one/dt",
              "is not allowed"},
        Fault{one_run, R"("one": {"engine": "custom", "seconds": 1, "compare_with": "two"})",
              "/claim/runs/one/compare_with", "\"one\""},
        Fault{R"("one": {"engine": "custom")", R"("1 one": {"engine": "custom")", "/claim/runs/1 one",
              "a letter"},
        // of what takes too long
        Fault{one_run, R"("one": {"engine": "custom", "seconds": 3600, "dt": "1/960"})",
              "/claim/runs/one/seconds", "1e+06"},
        Fault{one_run, R"("one": {"engine": "custom", "seconds": 1000, "scene": "rain", "balls": 50000})",
              "/claim/runs/one/seconds", "times balls"},
        Fault{one_run,
              R"("one": {"engine": "custom", "seconds": 0.1, "scene": "rain", "balls": 2000, "trace": true})",
              "/claim/runs/one/trace", "1000"},
        // of formulas
        Fault{"abs(one.y0 + 1) < 1e-12", "one.y0 +", "/claim/holds/0", "one.impacts"},
        Fault{"abs(one.y0 + 1) < 1e-12", "two.y0 > 0", "/claim/holds/0", "one.impacts"},
        Fault{"abs(one.y0 + 1) < 1e-12", "system(1)", "/claim/holds/0", "one.impacts"},
        Fault{"abs(one.y0 + 1) < 1e-12", R"(one.y0 > 0, \u001b[2J)", "/claim/holds/0", ""}));

TEST_F(LessonFile, WithoutItsTextIsRefusedByItsName) {
    const fs::path file = write();
    fs::remove(folder / "lesson.md");
    try {
        static_cast<void>(load_lesson(file));
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("lesson.md"), std::string::npos) << error.what();
    }
}

TEST_F(LessonFile, RunsAreComparedByWhatTouchesWhatWhenTheyBegin) {
    replace(R"("parts": [])",
            R"("parts": [{"name": "p", "shape": {"type": "segment", "a": [-1, -0.1], "b": [1, -0.1]}}])");
    replace(one_run,
            std::string(one_run) + R"(, "two": {"engine": "box2d", "seconds": 0.1, "compare_with": "one"},
        "apart": {"engine": "custom", "seconds": 0.1, "compare_with": "one", "scene":
            {"format": "flipside-scene/1", "name": "apart", "bounds": {"min": [-9, -9], "max": [9, 9]},
             "balls": [{"position": [0, 1], "radius": 0.1, "mass": 1}],
             "parts": [{"name": "p", "shape": {"type": "segment", "a": [-1, -0.1], "b": [1, -0.1]}}]}})");
    const Figures figures = measure(load_lesson(write()).claim);
    EXPECT_EQ(figures.at("one.touching_first"), 1);
    EXPECT_EQ(figures.at("apart.touching_first"), 0);
    EXPECT_EQ(figures.at("two.touching_differs"), 0);
    EXPECT_EQ(figures.at("apart.touching_differs"), 1);
    EXPECT_EQ(figures.count("one.touching_differs"), 0U);
}

TEST_F(LessonFile, CountsBeginBeforeTheEnd) {
    replace(R"("seconds": 1)", R"("seconds": 1, "from": 2)");
    expect_refused("/claim/runs/one/from", "less than");
}

}  // namespace
}  // namespace flipside::lab
