#include "lab/sweep/summary.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lab/csv_table.hpp"
#include "lab/data_file.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::sweep {
namespace {

namespace fs = std::filesystem;

constexpr double inf = std::numeric_limits<double>::infinity();

using Runs = std::vector<Run>;  // within a test, Run is one of gtest's own

Run run(const char* entrant, double dt, std::size_t window, double error) {
    Run made{"toy", entrant, dt, window, 0.5, {"", error, error / 2, 3, 1, 0}, 1e-3, 2e-3};
    if (error == inf) made.outcome.failure = "lost ball";
    return made;
}

class SweepSummary : public ::testing::Test {
  protected:
    fs::path base = fs::temp_directory_path() / ("flipside-summary-" + std::to_string(getpid()));
    void TearDown() override { fs::remove_all(base); }

    /// With these runs, by block.
    fs::path folder(const char* name, const Plan& plan, const std::vector<Runs>& blocks) const {
        fs::path made = base / name;
        fs::create_directories(made / "runs");
        const std::string text = to_json(plan);
        write_plan(made, text);
        for (std::uint32_t block = 0; block < blocks.size(); ++block) {
            const Unit unit{&plan.variants.front(), block};
            if (!blocks[block].empty())
                write_data_file(runs_file(unit, made), origin_of_unit("runs", text, unit),
                                to_csv(blocks[block]));
        }
        return made;
    }
};

TEST_F(SweepSummary, RefusesNamesThatAreMoreThanNames) {
    const Plan plan = quick_plan(variants_of({"toy"}, 0), 1);
    const Run good = run("box2d", 1.0 / 60, 0, 0.1);
    int which = 0;
    for (const char* bad : {"a\nsystem 'touch RUN'\n#", "<script>", "../a", "=1+1", "\x1b[31m", "\u202e"})
        for (const char* column : {"variant", "entrant", "failure"}) {
            Run hostile = good;
            (column[0] == 'v'   ? hostile.variant
             : column[0] == 'e' ? hostile.entrant
                                : hostile.outcome.failure) = bad;
            const fs::path made = folder(std::to_string(which++).c_str(), plan, {good, hostile});
            try {
                static_cast<void>(gather({&made, 1}));
                ADD_FAILURE() << column << ": " << bad;
            } catch (const InputError& error) {
                EXPECT_NE(std::string(error.what()).find(std::string(": line 3: ") + column),
                          std::string::npos)
                    << error.what();
            }
        }
}

TEST_F(SweepSummary, RefusesWindowsFilesThatAreMoreThanNames) {
    fs::create_directories(base / "windows");
    write_whole_file(base / "windows" / "toy-001.json",
                     R"({"windows": [], "trajectories": 3, "skipped": {}})");
    EXPECT_EQ(count_windows({&base, 1}).at("toy").trajectories, 3U);
    write_whole_file(base / "windows" / "a\x1b[31m-001.json", "{}");
    EXPECT_THROW(static_cast<void>(count_windows({&base, 1})), InputError);
}

TEST(SweepVariants, HavePlainNamesAndDifferentOnes) {
    const fs::path folder = fs::temp_directory_path() / ("flipside-variants-" + std::to_string(getpid()));
    fs::create_directory(folder);
    const auto scene = [&](const std::string& file, const std::string& name) {
        write_whole_file(
            folder / file,
            R"({"format": "flipside-scene/1", "bounds": {"min": [0, 0], "max": [1, 1]}, "name": )" + name +
                "}");
        return (folder / file).string();
    };
    const std::string a = scene("a.json", R"("same")"), b = scene("b.json", R"("same")"),
                      c = scene("c.json", R"("other")");
    EXPECT_EQ(variants_of({a, c}, 0).size(), 2U);
    EXPECT_THROW(static_cast<void>(variants_of({a, b}, 0)), InputError);
    EXPECT_THROW(static_cast<void>(variants_of({"toy", "toy"}, 0)), InputError);
    for (const char* bad :
         {R"("../x")", R"("a\nb")", R"("\u001b[31m")", R"("a b")", R"("=1")", R"("\u202e")"})
        EXPECT_THROW(static_cast<void>(variants_of({scene("bad.json", bad)}, 0)), InputError) << bad;
    fs::remove_all(folder);
}

TEST_F(SweepSummary, FiguresByNearestRankWithFailuresAsInfinite) {
    Runs runs;
    for (std::size_t i = 0; i < 20; ++i) runs.push_back(run("box2d", 1.0 / 60, i, 0.01 * double(20 - i)));
    runs[3] = run("box2d", 1.0 / 60, 3, inf);
    runs[5].cpu_min = runs[5].cpu_median = std::nan("");
    const std::vector<Figures> all = summarize(runs);
    ASSERT_EQ(all.size(), 1U);
    const Figures& f = all.front();
    EXPECT_EQ(f.engine, "box2d");
    EXPECT_EQ(f.windows, 20U);
    EXPECT_EQ(f.failed, 1U);
    EXPECT_EQ(f.failures.at("lost ball"), 1U);
    EXPECT_DOUBLE_EQ(f.median, 0.10);  // 0.01 … 0.20 without 0.17, which is infinite: the 10th of 20
    EXPECT_DOUBLE_EQ(f.p95, 0.20);     // the 19th
    EXPECT_EQ(f.max, inf);
    EXPECT_DOUBLE_EQ(f.typical_median, 0.05);
    EXPECT_EQ(f.impacts, 60U);
    EXPECT_EQ(f.missed, 20U);
    EXPECT_EQ(f.timed, 19U);
    EXPECT_NEAR(f.cpu_min, 2e-3, 1e-15);
    EXPECT_NEAR(f.cpu_median, 4e-3, 1e-15);
}

TEST_F(SweepSummary, FoldersTogetherAreAsOne) {
    const Plan plan{.variants = variants_of({"toy"}, 0), .block_size = 1};
    const Runs a{run("custom-discrete", 1.0 / 60, 0, 0.3), run("box2d", 1.0 / 30, 0, 0.2),
                 run("box2d", 1.0 / 60, 0, 0.1)};
    const Runs b{run("custom-discrete", 1.0 / 60, 1, 0.5), run("box2d", 1.0 / 30, 1, 0.4),
                 run("box2d", 1.0 / 60, 1, inf)};
    const fs::path apart[] = {folder("b", plan, {{}, b}), folder("a", plan, {a}), folder("again", plan, {a})};
    const fs::path whole[] = {folder("ab", plan, {a, b})};
    const auto figures = summarize(gather(apart));
    write_summary(base / "apart.csv", figures);
    write_summary(base / "whole.csv", summarize(gather(whole)));
    const CsvTable first(base / "apart.csv"), second(base / "whole.csv");
    ASSERT_EQ(first.rows(), 3U);
    for (std::size_t i = 0; i < first.rows(); ++i)
        for (const std::string& column : first.columns())
            EXPECT_EQ(first.text(i, column), second.text(i, column)) << column;
    EXPECT_EQ(first.number(0, "dt"), 1.0 / 30);
    EXPECT_EQ(first.number(0, "median"), 0.2);
    EXPECT_EQ(first.number(1, "max"), inf);
    EXPECT_EQ(first.text(1, "failures"), "1 lost ball");
    EXPECT_EQ(first.text(2, "entrant"), "custom-discrete");
}

TEST_F(SweepSummary, RefusesWhatDoesNotBelongTogether) {
    Plan plan{.variants = variants_of({"toy"}, 0)}, other = plan;
    other.seed = 2;
    const Runs runs{run("box2d", 1.0 / 60, 0, 0.1)};
    const fs::path folders[] = {folder("a", plan, {runs}), folder("b", other, {runs})};
    EXPECT_THROW(static_cast<void>(gather(folders)), InputError);
    fs::remove_all(folders[0] / "runs");
    EXPECT_THROW(static_cast<void>(gather({folders, 1})), InputError);
    EXPECT_THROW(static_cast<void>(gather({&base, 1})), InputError);
}

}  // namespace
}  // namespace flipside::lab::sweep
