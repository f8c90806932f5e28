#include "lab/sweep/summary.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "lab/files/csv_table.hpp"
#include "lab/files/data_file.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/sweep/blame_counts.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::sweep {
namespace {

namespace fs = std::filesystem;

constexpr double inf = std::numeric_limits<double>::infinity();

using Runs = std::vector<Run>;  // within a test, Run is one of gtest's own

Run run(const char* contender, double dt, std::size_t window, double error) {
    Run made{"toy", contender, dt, window, 0.5, {"", error, error / 2, 3, 1, 0}, {}, 1e-3, 2e-3};
    if (error == inf) made.outcome.failure = "lost ball";
    if (diverged(made.outcome)) made.blame = {Fault::late, "arc", "corner", 0, 1.5, 0.002};
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

/// What a script, a page, a path, a spreadsheet or a terminal would take for more than a name.
constexpr const char* hostile_names[] = {"a\nsystem 'touch RUN'\n#",
                                         "<script>",
                                         "../a",
                                         "=1+1",
                                         "-1",
                                         "\x1b[31m",
                                         "\x7f",
                                         "\u009b",
                                         "\u202e",
                                         "\xff",
                                         "a b",
                                         ""};

std::string in_quotes_of_csv(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

/// The folder is whole and its checksums hold: whoever made it meant it.
TEST_F(SweepSummary, RefusesRunsWhoseNamesAreMoreThanNames) {
    const Plan plan = quick_plan(variants_of({"toy"}, 0), 1);
    const std::string good = to_csv({run("box2d", 1.0 / 60, 0, 0.1)});
    const fs::path made = folder("hostile", plan, {});
    const Unit unit{&plan.variants.front(), 0};
    const std::string origin = origin_of_unit("runs", to_json(plan), unit);
    const auto refusal = [&](const std::string& row) -> std::string {
        write_data_file(runs_file(unit, made), origin, good + row);
        try {
            static_cast<void>(gather({&made, 1}));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    const std::string blame = ",late,arc,corner,0,1.5,0.002";
    for (const std::string bad : hostile_names) {
        const std::string field = in_quotes_of_csv(bad), rest = ",0.1,0.05,3,1,0" + blame + ",nan,nan\n";
        EXPECT_NE(refusal(field + ",box2d,0.016666666666666666,1,0.5," + rest).find(": line 3: variant '"),
                  std::string::npos);
        EXPECT_NE(
            refusal("toy," + field + ",0.016666666666666666,1,0.5," + rest).find(": line 3: contender '"),
            std::string::npos);
        if (bad.empty()) continue;  // a run that did not fail
        EXPECT_NE(refusal("toy,box2d,0.016666666666666666,1,0.5," + field + rest).find(": line 3: failure '"),
                  std::string::npos);
    }
    const std::string begun = "toy,box2d,0.016666666666666666,1,0.5,,", end = ",nan,nan\n";
    EXPECT_EQ(refusal(begun + "0.1,0.05,3,1,0" + blame + end), "");
    // What diverged is blamed on something that there is, and nothing else is.
    const std::pair<const char*, const char*> bad_blame[] = {{",,,,,,", "fault ''"},
                                                             {",luck,arc,corner,0,1.5,0.002", "fault 'luck'"},
                                                             {",late,moon,corner,0,1.5,0.002", "kind 'moon'"},
                                                             {",late,arc,\x1b[31m,0,1.5,0.002", "met '"},
                                                             {",late,arc,corner,-1,1.5,0.002", "ball '-1'"},
                                                             {",late,arc,corner,4294967296,1.5,0", "ball '"},
                                                             {",late,arc,corner,0,inf,0.002", "at 'inf'"},
                                                             {",late,arc,corner,0,1.5,-1", "amount '-1'"}};
    for (const auto& [fields, named] : bad_blame)
        EXPECT_NE(refusal(begun + "0.1,0.05,3,1,0" + fields + end).find(": line 3: " + std::string(named)),
                  std::string::npos)
            << fields;
    EXPECT_NE(refusal(begun + "1e-10,0,3,1,0" + blame + end).find(": line 3: fault 'late'"),
              std::string::npos);
    EXPECT_EQ(refusal(begun + "1e-10,0,3,1,0,,,,,," + end), "");
}

TEST_F(SweepSummary, RefusesPlansWhoseNamesAreMoreThanNames) {
    auto json = nlohmann::json::parse(to_json(quick_plan(variants_of({"toy"}, 0), 1)));
    EXPECT_EQ(parse_plan(json.dump(), "plan.json").variants.size(), 1U);
    for (const std::string bad : hostile_names) {
        if (bad == "\xff") continue;  // which JSON cannot hold
        json["variants"][0]["name"] = bad;
        try {
            static_cast<void>(parse_plan(json.dump(), "plan.json"));
            ADD_FAILURE() << bad;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("plan.json: /variants/0"), std::string::npos)
                << error.what();
        }
    }
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

TEST_F(SweepSummary, BlameIsCountedByFaultKindAndPart) {
    Runs runs;
    for (std::size_t i = 0; i < 10; ++i) runs.push_back(run("box2d", 1.0 / 30, i, i == 0 ? 1e-10 : 0.1));
    for (std::size_t i = 0; i < 10; ++i) runs.push_back(run("box2d", 1.0 / 60, i, i == 1 ? inf : 0.1));
    runs[3].blame = runs[13].blame = {Fault::late, "arc", "rim", 0, 1.5, 0.002};
    for (const std::size_t i : {4U, 5U, 15U, 16U}) runs[i].blame = {Fault::drift, "none", "", 0, 1.5, 0.002};
    const std::vector<Figures> all = summarize(runs);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].blame.at({Fault::late, "arc", "corner"}), 6U);
    EXPECT_EQ(all[0].blame.at({Fault::late, "arc", "rim"}), 1U);
    EXPECT_EQ(all[0].blame.at({Fault::drift, "none", ""}), 2U);
    const std::vector<BlameShares> shares = blame_shares(all);
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_EQ(shares[0].divergences, 19U);
    ASSERT_EQ(shares[0].shares.size(), 2U);
    EXPECT_EQ(shares[0].shares[0].count, 15U);
    EXPECT_EQ(shares[0].shares[0].part, "corner");
    EXPECT_EQ(sentence_of(shares[0]),
              "Of the 19 divergences of box2d on toy 79 % begin at arcs, as late contacts, and 21 % begin in "
              "flight, as drift.");
    fs::create_directories(base);
    write_blame(base / "blame.csv", all);
    const CsvTable table(base / "blame.csv");
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < table.rows(); ++i) sum += table.count(i, "divergences");
    EXPECT_EQ(sum, 19U);
    EXPECT_EQ(table.text(0, "stage"), "integration");
    EXPECT_EQ(table.text(1, "met"), "corner");
}

TEST_F(SweepSummary, FoldersTogetherAreAsOne) {
    const Plan plan{.variants = variants_of({"toy"}, 0), .block_size = 1};
    const Runs a{run("custom-simple", 1.0 / 60, 0, 0.3), run("box2d", 1.0 / 30, 0, 0.2),
                 run("box2d", 1.0 / 60, 0, 0.1)};
    const Runs b{run("custom-simple", 1.0 / 60, 1, 0.5), run("box2d", 1.0 / 30, 1, 0.4),
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
    EXPECT_EQ(first.text(2, "contender"), "custom-simple");
    for (const Figures& f : figures) EXPECT_EQ(f.blame.at({Fault::late, "arc", "corner"}), 2U);
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
