// Every call to the system that can fail does, one after the other, in the program as it is shipped: files
// are whole or as they were, one line says what happened, and the same command does it all afterwards.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <unistd.h>

#include "places.hpp"
#include "scenarios.hpp"

namespace flipside::faults {
namespace {

namespace fs = std::filesystem;

/// How much is tried: FLIPSIDE_FAULTS=all tries every call of every kind, which takes an hour.
bool tries_all() {
    const char* const wish = std::getenv("FLIPSIDE_FAULTS");
    return wish != nullptr && std::string(wish) == "all";
}

struct Kind {
    const char* name;
    bool may_refuse;  ///< it is about reading, and what cannot be read may be called bad input
    bool may_pass;    ///< the program may do without, or try again
};
constexpr Kind kinds[] = {{"write", false, false}, {"short", false, true},   {"interrupted", false, true},
                          {"sync", false, false},  {"rename", false, false}, {"open", true, true},
                          {"close", false, true},  {"folder", false, true},  {"input", true, true},
                          {"read", true, true},    {"spawn", false, false},  {"memory", false, true}};

/// Which of `count` calls fail: all where there are few; else the first ones, and then ever fewer.
std::set<long> chosen(long count, long most) {
    std::set<long> all;
    if (count <= most || tries_all()) {
        for (long k = 1; k <= count; ++k) all.insert(k);
        return all;
    }
    std::mt19937 dice(1);
    const auto half = static_cast<double>(most) / 2;
    for (double i = 0; i < half; ++i) all.insert(std::lround(std::pow(static_cast<double>(count), i / half)));
    std::uniform_int_distribution<long> any(1, count);
    while (static_cast<long>(all.size()) < most) all.insert(any(dice));
    return all;
}

class Faults : public ::testing::Test {
  protected:
    fs::path base = fs::temp_directory_path() / ("flipside-faults-" + std::to_string(getpid()));
    Scenarios scenarios{base};
    fs::path folder = base / "now";

    void begin(const Scenario& scenario) const {
        fs::remove_all(folder);
        fs::copy(scenario.folder, folder, fs::copy_options::recursive);
    }
    [[nodiscard]] Ended run_with(const Scenario& scenario, const std::string& fault) const {
        begin(scenario);
        return Child(scenario.command, folder,
                     {std::string("LD_PRELOAD=") + test::fault_library, "FLIPSIDE_FAULT=" + fault,
                      "FLIPSIDE_FAULT_IN=" + scenario.program,
                      "FLIPSIDE_FAULT_COUNT=" + (base / "counts").string()})
            .wait();
    }
    /// Calls of each kind in an undisturbed run.
    [[nodiscard]] std::map<std::string, long> counts(const Scenario& scenario) const {
        const Ended ended = run_with(scenario, "write:0");
        EXPECT_EQ(ended.code, 0) << ended.err;
        std::map<std::string, long> all;
        std::ifstream in(base / "counts");
        for (std::string kind; in >> kind;) in >> all[kind];
        return all;
    }

    void expect_whole(const Scenario& scenario, const Kind& kind, const std::string& fault,
                      const Contents& before, const Contents& after, bool resumes) const {
        SCOPED_TRACE(scenario.name + ", " + fault + " in " + scenario.program);
        const Ended ended = run_with(scenario, fault);
        EXPECT_EQ(unclear_end(ended, kind.may_refuse), "");
        EXPECT_TRUE(kind.may_pass || ended.code != 0);
        const Contents found = contents_of(folder);
        EXPECT_EQ(half_files(found, before, after), "");
        EXPECT_TRUE(ended.code != 0 || found == after) << "exit 0 without all files";
        if (!resumes) return;
        const Ended again = Child(scenario.command, folder).wait();
        EXPECT_EQ(again.code, 0) << again.err;
        EXPECT_TRUE(contents_of(folder) == after) << "the same command afterwards";
    }

    /// At most `most` calls of each kind, of memory three times as many; the same command follows on every
    /// `every`-th.
    void expect_whole_after_every_fault(const Scenario& scenario, long most, long every) const {
        begin(scenario);
        const Contents before = contents_of(folder);
        run_undisturbed(scenario, folder);
        const Contents after = contents_of(folder);
        ASSERT_NE(before, after);
        const auto calls = counts(scenario);
        ASSERT_GT(calls.at("write"), 0);
        ASSERT_GT(calls.at("memory"), 1000);
        long tried = 0;
        for (const Kind& kind : kinds) {
            const long count = calls.at(kind.name);
            for (const long k : chosen(count, std::string_view(kind.name) == "memory" ? 3 * most : most)) {
                const bool resumes = tries_all() || k % every == 0;
                const std::string fault = std::string(kind.name) + ":" + std::to_string(k);
                expect_whole(scenario, kind, fault, before, after, resumes);
                ++tried;
                // A signal that comes again for ever leaves no time to write.
                if (std::string_view(kind.name) == "interrupted" || (k % 3 != 0 && !tries_all())) continue;
                expect_whole(scenario, kind, fault + "+", before, after, resumes);
                ++tried;
            }
        }
        RecordProperty("faults", std::to_string(tried));
        std::cout << scenario.name << ": " << tried << " faults\n";
    }
};

TEST_F(Faults, OfARun) {
    expect_whole_after_every_fault(scenarios.run(), 30, 5);
}

TEST_F(Faults, OfTheBeginOfASweep) {
    expect_whole_after_every_fault(scenarios.sweep_begin(), 10, 2);
}

TEST_F(Faults, OfTheEndOfASweep) {
    expect_whole_after_every_fault(scenarios.sweep_end(), 6, 2);
}

/// A report takes seconds: a few faults of each kind are for FLIPSIDE_FAULTS=all.
TEST_F(Faults, OfAReport) {
    const Scenario scenario = scenarios.report("tiny_report");
    if (tries_all()) return expect_whole_after_every_fault(scenario, 1, 1);
    begin(scenario);
    const Contents before = contents_of(folder);
    run_undisturbed(scenario, folder);
    const Contents after = contents_of(folder);
    for (const char* fault : {"write:20", "rename:30+"}) {
        const Kind kind{fault, false, false};
        expect_whole(scenario, kind, fault, before, after, false);
    }
}

}  // namespace
}  // namespace flipside::faults
