// A whole sweep of a few windows: in one go, in shards, and stopped and taken up again.

#include "lab/sweep/sweep.hpp"

#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lab/files/assets.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/process/failure.hpp"
#include "lab/sweep/blame_counts.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab::sweep {
namespace {

namespace fs = std::filesystem;

/// Two windows of pinball with one ball each, in four blocks, at 1/30 and 1/60 s.
Plan small_plan() {
    Plan plan{.variants = variants_of({"pinball"}, 1)};
    plan.blocks = 4;
    plan.block_size = 2;
    plan.timed = 1;
    plan.repetitions = 2;
    plan.finest = 60;
    return plan;
}

const std::function<void(double)> unwatched = [](double) {};
/// Where nothing is damaged, nothing is noticed.
const Notice unnoticed = [](const std::string& sentence) { ADD_FAILURE() << sentence; };

bool is_complete(const fs::path& folder) {
    return take_inventory(small_plan(), folder).is_complete;
}

/// Without the checksum, which is of measured times too.
std::string text_in(const fs::path& file) {
    const std::string text = read_file(file);
    const std::size_t last = text.rfind("# flipside-data/");
    return text.substr(0, last);
}

/// Everything in a folder's files but what is measured in time, by file, row and column.
std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (entry.path().extension() == ".json") all[name] = read_file(entry.path());
        if (entry.path().extension() == ".part") ADD_FAILURE() << name << " was left behind";
        if (entry.path().extension() != ".csv") continue;
        const CsvTable table(entry.path(), text_in(entry.path()));
        for (std::size_t row = 0; row < table.rows(); ++row)
            for (const std::string& column : table.columns())
                if (!column.starts_with("cpu_"))
                    all[name + ':' + std::to_string(row) + ':' + column] = table.text(row, column);
    }
    return all;
}

class Sweeps : public ::testing::Test {
  protected:
    static inline const fs::path base =
        fs::temp_directory_path() / ("flipside-sweep-" + std::to_string(getpid()));
    static void SetUpTestSuite() { make_runs(small_plan(), {}, base / "whole", unwatched, unnoticed); }
    static void TearDownTestSuite() { fs::remove_all(base); }

    static std::map<std::string, std::string> figures(std::span<const fs::path> folders) {
        const fs::path made = base / "figures";
        fs::create_directories(made);
        write_summary(made / "sweep.csv", summarize(gather(folders)));
        write_blame(made / "blame.csv", summarize(gather(folders)));
        return contents(made);
    }
};

TEST_F(Sweeps, MeasureEveryContenderOnEveryWindow) {
    const fs::path folder = base / "whole";
    EXPECT_TRUE(is_complete(folder));
    const std::vector<Figures> all = summarize(gather({&folder, 1}));
    std::size_t lanes = 0;
    for (const Contender& contender : contenders()) lanes += steps_of(contender, small_plan()).size();
    ASSERT_EQ(all.size(), lanes);
    for (const Figures& f : all) {
        EXPECT_EQ(f.windows, small_plan().windows()) << f.contender;
        EXPECT_EQ(f.timed, small_plan().blocks) << f.contender;
        EXPECT_GT(f.cpu_min, 0) << f.contender;
        EXPECT_LE(f.cpu_min, f.cpu_median) << f.contender;
        EXPECT_GE(f.impacts, f.windows) << f.contender;
        std::size_t blamed = 0;
        for (const auto& [key, count] : f.blame) {
            blamed += count;
            EXPECT_NE(key.fault, Fault::unknown) << f.contender;
            const bool met = key.fault != Fault::drift && key.fault != Fault::stopped;
            EXPECT_EQ(met, key.kind != "none") << f.contender << ' ' << name_of(key.fault);
            EXPECT_EQ(met, !key.met.empty()) << f.contender << ' ' << name_of(key.fault);
        }
        EXPECT_EQ(blamed, f.windows - f.exact) << f.contender;
    }
    const Inventory inventory = take_inventory(small_plan(), folder);
    EXPECT_EQ(inventory.windows.at("pinball-1").windows, small_plan().windows());
}

TEST_F(Sweeps, ShardsTogetherAreOneRun) {
    std::vector<fs::path> shards;
    for (const std::size_t shard : {3U, 1U, 4U, 2U}) {
        shards.push_back(base / ("shard-" + std::to_string(shard)));
        make_runs(small_plan(), {shard, 4}, shards.back(), unwatched, unnoticed);
        EXPECT_FALSE(is_complete(shards.back()));
    }
    const fs::path whole = base / "whole";
    EXPECT_EQ(figures(shards), figures({&whole, 1}));
    std::map<std::string, std::string> files;
    for (const fs::path& shard : shards) files.merge(contents(shard));
    EXPECT_EQ(files, contents(whole));
}

TEST_F(Sweeps, StoppedAnywhereAndTakenUpAgainEndTheSame) {
    const fs::path folder = base / "stopped";
    for (int patience = 5; !is_complete(folder); patience += 40) {
        int calls = 0;
        const auto impatient = [&](double share) {
            EXPECT_GE(share, 0);
            EXPECT_LE(share, 1 + 1e-9);
            if (++calls > patience) throw Failure("interrupted");
        };
        try {
            make_runs(small_plan(), {}, folder, impatient, unnoticed);
        } catch (const Failure&) {
            EXPECT_LT(contents(folder).size(), contents(base / "whole").size());
        }
    }
    EXPECT_EQ(contents(folder), contents(base / "whole"));
}

TEST_F(Sweeps, AFolderHoldsOnePlan) {
    Plan other = small_plan();
    other.seed = 2;
    EXPECT_THROW(make_runs(other, {}, base / "whole", unwatched, unnoticed), InputError);
}

TEST(SweepWindows, HoldAHitAndAKnownEnd) {
    for (const Variant& variant : standard_variants()) {
        const auto scene = load(variant);
        const Block block = make_block({variant, 7, 0, 2}, scene, reference_for(*scene), [] {});
        EXPECT_EQ(block.windows.size(), 2U) << variant.name;
        for (const Window& window : block.windows) {
            EXPECT_GE(window.seconds, variant.shortest * window_unit);
            EXPECT_LE(window.seconds, variant.longest * window_unit);
            if (variant.balls > 0) {
                EXPECT_EQ(window.start.balls.size(), static_cast<std::size_t>(variant.balls));
            }
            EXPECT_FALSE(window.impacts.empty());
            EXPECT_TRUE(std::ranges::any_of(window.ends, &Window::End::hit));
            for (const Window::End& end : window.ends)
                EXPECT_LE(end.uncertainty, claim_radii * end.radius) << variant.name;
        }
    }
}

TEST(SweepWindows, AreReadBackAsTheyWere) {
    const Variant variant = standard_variants().front();
    const auto scene = load(variant);
    const Block block = make_block({variant, 7, 3, 3}, scene, reference_for(*scene), [] {});
    const BlockPlan plan{variant, 7, 3, 3};
    const Block read = parse_block(to_json(block, *scene), "test", plan, *scene);
    EXPECT_EQ(read.skipped, block.skipped);
    ASSERT_EQ(read.windows.size(), block.windows.size());
    for (std::size_t i = 0; i < read.windows.size(); ++i) {
        const Window &a = block.windows[i], &b = read.windows[i];
        EXPECT_EQ(a.start.balls, b.start.balls);
        EXPECT_EQ(a.start.parts, b.start.parts);
        EXPECT_EQ(a.start.clock, b.start.clock);
        EXPECT_EQ(a.seconds, b.seconds);
        ASSERT_EQ(a.ends.size(), b.ends.size());
        EXPECT_EQ(a.ends.front().position, b.ends.front().position);
        ASSERT_EQ(a.impacts.size(), b.impacts.size());
        EXPECT_EQ(count_unmatched(a.impacts, b.impacts, 0, 1e9).first, 0U);
    }
    EXPECT_THROW(static_cast<void>(parse_block("{}", "test", plan, *scene)), InputError);
}

}  // namespace
}  // namespace flipside::lab::sweep
