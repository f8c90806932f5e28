// Files of a sweep and of a report that were damaged in every way that comes to mind: each is named, and made
// again where it is ours, refused where it was handed over; figures are those of an undamaged one.

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "../lab/report/made_up_sweep.hpp"
#include "../lab/report/tiny_effort.hpp"
#include "damages.hpp"
#include "in_small.hpp"
#include "lab/process/failure.hpp"
#include "lab/report/report.hpp"
#include "places.hpp"
#include "scenarios.hpp"

namespace flipside::faults {
namespace {

namespace fs = std::filesystem;

constexpr auto recursive = fs::copy_options::recursive;

class Damages : public ::testing::Test {
  protected:
    static inline const fs::path base =
        fs::temp_directory_path() / ("flipside-damages-" + std::to_string(getpid()));
    const fs::path folder = base / "now";

    static void SetUpTestSuite() {
        fs::create_directories(base / "whole");
        for (const char* seed : {"1", "2"}) EXPECT_EQ(sweep(base / "whole", seed).code, 0);
    }
    static void TearDownTestSuite() { fs::remove_all(base); }

    static Ended sweep(const fs::path& where, const std::string& seed, const std::string& scene = "drop") {
        return Child({test::flipside_program, "sweep", scene, "--contenders", "box2d", "--finest", "30",
                      "--quick", "--seed", seed, "--out", "sweep-" + seed},
                     where)
            .wait();
    }
    void begin() const {
        fs::remove_all(folder);
        fs::create_directory(folder);
        fs::copy(base / "whole" / "sweep-1", folder / "sweep-1", recursive);
    }
    static void expect_line(const Ended& ended, const std::string& name) {
        EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
        EXPECT_TRUE(ended.err.starts_with("flipside: ")) << ended.err;
        EXPECT_NE(ended.err.find(name), std::string::npos) << ended.err;
        for (const char c : ended.err.substr(0, ended.err.size() - 1))
            EXPECT_TRUE(c >= ' ' || c < 0) << ended.err;
    }
    /// The file in its place, and one that belongs into another.
    struct File {
        const char *name, *foreign;
    };
};

TEST_F(Damages, OfASweepAreNamedAndMadeAgain) {
    const Contents whole = contents_of(base / "whole" / "sweep-1");
    const File files[] = {{"plan.json", "sweep-1/runs/drop-001.csv"},
                          {"windows/drop-002.json", "sweep-2/windows/drop-002.json"},
                          {"runs/drop-002.csv", "sweep-2/runs/drop-002.csv"},
                          {"windows/drop-002.json", "sweep-1/windows/drop-003.json"},
                          {"runs/drop-002.csv", "sweep-1/runs/drop-003.csv"}};
    int tried = 0;
    for (const auto& [name, foreign] : files) {
        for (const Damage& damage : damages(base / "whole" / foreign)) {
            SCOPED_TRACE(std::string(name) + ": " + damage.name);
            const char* const& last = files[test::in_small ? 0 : 2].name;  // that gets all damages
            if (&name > &last && std::string(damage.name) != "foreign") continue;
            begin();
            damage.act(folder / "sweep-1" / name);
            const Ended ended = sweep(folder, "1");
            expect_line(ended, name);
            ++tried;
            if (damage.is_obstacle) {
                EXPECT_TRUE(ended.code == 1 || ended.code == 2) << ended.code << ": " << ended.err;
                continue;
            }
            EXPECT_EQ(ended.code, 0) << ended.err;
            EXPECT_NE(ended.err.find("made again"), std::string::npos) << ended.err;
            EXPECT_TRUE(contents_of(folder / "sweep-1") == whole);
        }
    }
    std::cout << tried << " damaged files of a sweep\n";
}

TEST_F(Damages, OfFoldersThatWereHandedOverAreRefused) {
    const File files[] = {{"plan.json", "sweep-2/plan.json"},
                          {"runs/drop-002.csv", "sweep-2/runs/drop-002.csv"}};
    int tried = 0;
    for (const auto& [name, foreign] : files) {
        for (const Damage& damage : damages(base / "whole" / foreign)) {
            SCOPED_TRACE(std::string(name) + ": " + damage.name);
            begin();
            damage.act(folder / "sweep-1" / name);
            const Ended ended =
                Child({test::flipside_program, "report", "--quick", "--from", "sweep-1", "--out", "report"},
                      folder)
                    .wait();
            EXPECT_EQ(ended.code, 2) << ended.err;
            // The plan of another sweep is whole: it is the runs that do not belong to it.
            expect_line(ended, std::string(damage.name) == "foreign" ? "runs/" : name);
            EXPECT_FALSE(fs::exists(folder / "report")) << "something was measured before";
            ++tried;
        }
    }
    std::cout << tried << " damaged files that were handed over\n";
}

TEST_F(Damages, ThePlanOfAnotherSweepIsNotOverwritten) {
    begin();
    const fs::path plan = folder / "sweep-1" / "plan.json";
    fs::copy(base / "whole" / "sweep-2" / "plan.json", plan, fs::copy_options::overwrite_existing);
    const std::string text = text_of(plan);
    const Ended ended = sweep(folder, "1");
    EXPECT_EQ(ended.code, 2) << ended.err;
    expect_line(ended, "plan.json");
    EXPECT_EQ(text_of(plan), text);
}

TEST_F(Damages, ASceneThatWasChangedMakesAnotherSweep) {
    fs::remove_all(folder);
    fs::create_directory(folder);
    const fs::path scene = folder / "mine.json";
    fs::copy(test::source("assets/scenes/drop.json"), scene);
    EXPECT_EQ(sweep(folder, "1", scene.string()).code, 0);
    std::ofstream(scene, std::ios::app) << '\n';
    const Ended ended = sweep(folder, "1", scene.string());
    EXPECT_EQ(ended.code, 2) << ended.err;
    expect_line(ended, "plan.json");
}

/// What a report's data say, told by the notices.
struct Notices {
    std::vector<std::string> said;
    [[nodiscard]] lab::Notice take() {
        return [this](const std::string& sentence) { said.push_back(sentence); };
    }
};

/// Whether the report would take the file for its own; what it cannot read it may also refuse.
bool is_taken(const lab::report::Data& data, const std::string& file) {
    try {
        return data.has(file);
    } catch (const InputError&) {
        return false;
    }
}

TEST_F(Damages, OfAReportAreNamedAndMeasuredAgain) {
    using namespace lab::report;
    const auto unwatched = [](double) {};
    fs::create_directories(folder);
    Notices notices;
    const Data data(folder, "tiny", "unknown", notices.take());
    int tried = 0;
    for (const Chapter& chapter : chapters(tiny_effort(), {base / "whole" / "sweep-1"})) {
        if (chapter.measurements.empty()) continue;
        SCOPED_TRACE(chapter.id);
        fs::remove_all(folder);
        fs::create_directories(folder);
        const std::span<const Measurement> one(&chapter.measurements.back(), 1);
        take(one, data, unwatched);
        fs::remove(folder / "spent.csv");  // is no measurement
        ASSERT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
        const fs::path file = fs::directory_iterator(folder)->path();
        const Contents whole = contents_of(folder);
        const std::string text = text_of(file);
        for (const Damage& damage : damages(base / "whole" / "sweep-1" / "plan.json")) {
            SCOPED_TRACE(damage.name);
            damage.act(file);
            notices.said.clear();
            ++tried;
            if (damage.is_obstacle) {
                EXPECT_FALSE(is_taken(data, file.filename()));
            } else {
                EXPECT_FALSE(data.has(file.filename()));
                ASSERT_EQ(notices.said.size(), 1U);
                EXPECT_NE(notices.said[0].find(file.string()), std::string::npos) << notices.said[0];
                EXPECT_NE(notices.said[0].find("measured again"), std::string::npos) << notices.said[0];
            }
            fs::remove_all(file);
            std::ofstream(file, std::ios::binary) << text;
        }
        EXPECT_TRUE(data.has(file.filename()));
        damages({}).front().act(file);
        take(one, data, unwatched);
        fs::remove(folder / "spent.csv");
        EXPECT_TRUE(contents_of(folder) == whole);
    }
    std::cout << tried << " damaged files of a report\n";
}

TEST_F(Damages, OfTheNoteWhoseDataAReportHolds) {
    using namespace lab::report;
    fs::remove_all(folder);
    make_up_sweep(folder / "swept");
    const auto stop = [](double) { throw lab::Failure("stopped"); };
    Notices notices;
    const ReportInput input{folder / "report", {folder / "swept"}, tiny_effort()};
    EXPECT_THROW(make_report(input, stop, notices.take()), lab::Failure);
    const fs::path file = folder / "report" / "data" / "report.json";
    const std::string text = text_of(file);
    for (const Damage& damage : damages(base / "whole" / "sweep-1" / "plan.json")) {
        SCOPED_TRACE(damage.name);
        damage.act(file);
        notices.said.clear();
        if (damage.is_obstacle) {
            EXPECT_ANY_THROW(make_report(input, stop, notices.take()));
        } else {
            EXPECT_THROW(make_report(input, stop, notices.take()), lab::Failure);
            ASSERT_EQ(notices.said.size(), 1U);
            EXPECT_NE(notices.said[0].find(file.string()), std::string::npos) << notices.said[0];
            EXPECT_EQ(text_of(file), text);
        }
        fs::remove_all(file);
        std::ofstream(file, std::ios::binary) << text;
    }
}

}  // namespace
}  // namespace flipside::faults
