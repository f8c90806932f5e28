#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lab/contenders/engines.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/process/allocations.hpp"
#include "lab/process/failure.hpp"
#include "lab/session/timeline.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {
namespace {

namespace fs = std::filesystem;

TEST(Timeline, EndsExactlyWithOneShorterStepAtMost) {
    const Timeline even(0, 10, 1.0 / 60);
    EXPECT_EQ(even.steps(), 600U);
    EXPECT_EQ(even.length(599), 1.0 / 60);
    const Timeline odd(5, 1, 0.3);
    EXPECT_EQ(odd.steps(), 4U);
    EXPECT_EQ(odd.length(2), 0.3);
    EXPECT_NEAR(odd.length(3), 0.1, 1e-15);
    EXPECT_EQ(odd.end(), 6);
    EXPECT_EQ(Timeline(0, 0, 0.1).steps(), 0U);
    EXPECT_EQ(Timeline(0, 0.04, 0.1).length(0), 0.04);
}

TEST(Csv, NumbersReadBackToTheSameBits) {
    Ball ball;
    ball.number = 7;
    ball.position = {0.1, -1.0 / 3};
    ball.velocity = {1e-300, 12345678901234567.0};
    ball.angle = M_PI;
    std::ostringstream out;
    write_sample(out, 1.0 / 60, {&ball, 1});
    EXPECT_EQ(out.str(),
              "0.016666666666666666,7,0.10000000000000001,-0.33333333333333331,1e-300,"
              "12345678901234568,3.1415926535897931,0\n");
}

TEST(Csv, EventsNameWhatWasMet) {
    Scene scene;
    scene.parts.resize(2);
    scene.parts[0].name = "bumper";
    scene.parts[1].name = "a, \"b\"";
    const std::vector<Event> events{{0.5, EventKind::impact, 1, Other::part(0), {1, 2}, {0, 1}, 3, 4},
                                    {0.5, EventKind::begin, 1, Other::part(1), {}, {}, 0, 0},
                                    {1, EventKind::sensor_end, 2, Other::ball(9), {}, {}, 0, 0},
                                    {2, EventKind::lost, 2, {}, {5, 6}, {}, 0, 0}};
    std::ostringstream out;
    write_events(out, events, scene);
    EXPECT_EQ(out.str(),
              "0.5,impact,1,bumper,1,2,0,1,3,4\n"
              "0.5,begin,1,\"a, \"\"b\"\"\",0,0,0,0,0,0\n"
              "1,sensor-end,2,ball:9,0,0,0,0,0,0\n"
              "2,lost,2,,5,6,0,0,0,0\n");
}

TEST(Csv, TextIsInOneLineAndNoFormula) {
    std::ostringstream out;
    CsvRow row;
    for (const char* text : {"=1+1", "+1", "-1", "@a", "'a", "a=1"}) row.add(text);
    row.add(-1.0).add("a\nb\r\x1b\x7f\u202e\xff").add("=\"a\"").write(out);
    EXPECT_EQ(out.str(),
              "'=1+1,'+1,'-1,'@a,''a,a=1,-1,a\\x0ab\\x0d\\x1b\\x7f\\u{202e}\\xff,\"'=\"\"a\"\"\"\n");
}

class WholeFiles : public ::testing::Test {
  protected:
    fs::path folder = fs::temp_directory_path() / ("flipside-files-" + std::to_string(getpid()));
    void SetUp() override { fs::create_directory(folder); }
    void TearDown() override { fs::remove_all(folder); }

    static std::string text_of(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    [[nodiscard]] std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    }
};

TEST_F(WholeFiles, AppearWhenFinishedAndOnlyThen) {
    const fs::path target = folder / "a.csv";
    write_whole_file(target, "old");
    {
        WholeFile file(target);
        file.out() << "half";
        file.out().flush();
        EXPECT_EQ(text_of(target), "old");
    }
    EXPECT_EQ(text_of(target), "old");
    EXPECT_EQ(files(), 1);
    write_whole_file(target, "new");
    EXPECT_EQ(text_of(target), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(WholeFiles, LeaveALinkALink) {
    write_whole_file(folder / "real", "old");
    fs::create_symlink("real", folder / "link");
    write_whole_file(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(text_of(folder / "real"), "new");
    {
        WholeFile half(folder / "link");
        half.out() << "half" << std::flush;
        EXPECT_EQ(text_of(folder / "real"), "new");
    }
    EXPECT_EQ(files(), 2);
    fs::create_symlink("unmade", folder / "to nothing");
    write_whole_file(folder / "to nothing", "made");
    EXPECT_EQ(text_of(folder / "unmade"), "made");
}

TEST_F(WholeFiles, KeepThePermissionsOfWhatTheyReplace) {
    const fs::path target = folder / "private";
    write_whole_file(target, "old");
    constexpr auto own = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(target, own);
    write_whole_file(target, "new");
    EXPECT_EQ(text_of(target), "new");
    EXPECT_EQ(fs::status(target).permissions(), own);
}

TEST_F(WholeFiles, DoNotReplaceWhatMayNotBeWritten) {
    const fs::path target = folder / "protected";
    write_whole_file(target, "old");
    fs::permissions(target, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
    fs::permissions(folder, fs::perms::all);
    const auto try_to_replace = [&] {
        constexpr uid_t nobody = 65534;
        if (geteuid() == 0 && setuid(nobody) != 0) std::exit(2);  // root may write everything
        try {
            write_whole_file(target, "new");
            std::exit(1);
        } catch (const InputError&) {
            std::exit(0);
        }
    };
    EXPECT_EXIT(try_to_replace(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(text_of(target), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(WholeFiles, SayAtOnceWhyTheyCannotBeWritten) {
    WholeFile full("/dev/full");
    try {
        for (int line = 0; line < 100; ++line) full.out() << std::string(1000, 'x') << '\n';
        FAIL() << "100 kB were written to a full device";
    } catch (const Failure& failure) {
        EXPECT_STREQ(failure.what(), "/dev/full: cannot be written (No space left on device)");
    }
    fs::create_symlink("self", folder / "self");
    EXPECT_THROW(WholeFile(folder / "self"), InputError);
}

TEST_F(WholeFiles, MayHaveNamesAsLongAsNamesAre) {
    const fs::path target = folder / std::string(255, 'n');
    write_whole_file(target, "text");
    EXPECT_EQ(text_of(target), "text");
    EXPECT_EQ(files(), 1);
    EXPECT_THROW(write_whole_file(folder / std::string(256, 'n'), ""), InputError);
    EXPECT_THROW(write_whole_file(folder / std::string(256, 'n') / "x", ""), InputError);
    EXPECT_EQ(files(), 1);
}

TEST_F(WholeFiles, FailWhereNothingCanBeWritten) {
    EXPECT_THROW(WholeFile(folder / "none" / "a.csv"), InputError);
    EXPECT_THROW(WholeFile{folder}, InputError);
    EXPECT_THROW(write_whole_file("/dev/full", std::string(1 << 20, 'x')), Failure);
}

TEST(Steps, AreSecondsOrFractions) {
    EXPECT_EQ(parse_step("1/60"), 1.0 / 60);
    EXPECT_EQ(parse_step("0.01"), 0.01);
    for (const char* bad : {"", "0", "-1", "nan", "inf", "1/0", "2", "1e-9", "1/60s", "a"})
        EXPECT_THROW(static_cast<void>(parse_step(bad)), InputError) << bad;
}

TEST(SettingChanges, AreCheckedAgainstTheirEngine) {
    const Engine* const both[] = {&engine_named("custom"), &engine_named("box2d")};
    const std::span<const Engine* const> one(both, 1);
    const auto parse = [](std::string text, std::span<const Engine* const> used) {
        return parse_changes({&text, 1}, used);
    };
    EXPECT_EQ(parse("motion_iterations=7", one)[0].engine, both[0]);
    EXPECT_EQ(parse("box2d.substeps=2", both)[0].name, "substeps");
    for (const char* bad :
         {"motion_iterations", "motion_iterations=0.5", "=1", "zig.a=1", "box2d.substeps=2"})
        EXPECT_THROW(parse(bad, one), InputError) << bad;
    EXPECT_THROW(parse("motion_iterations=7", both), InputError);
    const std::vector<std::string> twice{"sleep=on", "custom.sleep=off"};
    EXPECT_THROW(static_cast<void>(parse_changes(twice, one)), InputError);
    const std::vector<std::string> of_each{"custom.sleep=on", "box2d.sleep=off"};
    EXPECT_EQ(parse_changes(of_each, both).size(), 2U);
}

TEST(SettingsFor, TakeTheScenesAdviceThenTheChanges) {
    Scene scene;
    scene.recommend["custom"]["motion_iterations"] = "9";
    scene.recommend["custom"]["collision_iterations"] = "8";
    scene.recommend["run"]["dt"] = "1/240";
    const Engine& custom = engine_named("custom");
    const std::vector<SettingChange> changes{{&custom, "collision_iterations", "3"},
                                             {&engine_named("box2d"), "substeps", "2"}};
    const Settings settings = settings_for(custom, scene, changes);
    EXPECT_EQ(settings.integer("motion_iterations"), 9);
    EXPECT_EQ(settings.integer("collision_iterations"), 3);
    EXPECT_EQ(step_for(scene), 1.0 / 240);
    scene.recommend["custom"]["motion_iterations"] = "lots";
    EXPECT_THROW(static_cast<void>(settings_for(custom, scene)), InputError);
}

TEST(Allocations, AreCounted) {
    const std::uint64_t before = allocations();
    auto* volatile number = new int(1);
    delete number;
    struct alignas(64) Wide {
        int a;
    };
    auto* volatile wide = new Wide{1};
    delete wide;
    EXPECT_EQ(allocations() - before, 2U);
}

}  // namespace
}  // namespace flipside::lab
