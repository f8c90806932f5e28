/// The real executable, as a shell would run it: exit codes, one clear line on stderr, whole and repeatable
/// files.

#include <csignal>

#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "in_small.hpp"
#include "places.hpp"

namespace flipside::app {
namespace {

TEST_F(CommandLine, BadUsageIsExitTwoAndOneLine) {
    expect_refused("run", 2, "scene");
    expect_refused("run drop", 2, "--engine");
    expect_refused("run nowhere --engine custom", 2, "pinball");
    expect_refused("run drop --engine zig", 2, "custom, box2d");
    expect_refused("run drop --engine custom --colour red", 2, "--colour");
    expect_refused("run drop --engine custom --seconds nan", 2, "--seconds");
    expect_refused("run drop --engine custom --seconds -1", 2, "--seconds");
    expect_refused("run drop --engine custom --dt 0", 2, "1/60");
    expect_refused("run drop --engine custom --every 0", 2, "--every");
    expect_refused("run drop --engine custom --set iterations=3", 2, "motion_iterations");
    expect_refused("run drop --engine custom --set motion_iterations=65", 2, "from 1 to 64");
    expect_refused("run drop --engine custom --set motion_iterations", 2, "no value");
    expect_refused("run drop --engine custom --balls 5", 2, "drop.json");
    expect_refused("run rain --engine custom --balls 1000001", 2, "from 1 to 1000000");
    expect_refused("run drop --engine custom --from " + file("none"), 2, "none");
    expect_refused("run drop --engine custom --script " + file("none"), 2, "none");
    expect_refused("compare drop --engines custom,custom", 2, "twice");
    expect_refused("compare drop --set substeps=2", 2, "ENGINE.");
    expect_refused("compare drop --contender a=custom --contender a=box2d", 2, "twice");
    expect_refused("compare drop --contender a=custom,dt=1/97 --contender b=box2d", 2, "does not divide");
    expect_refused("compare drop --contender a=custom --engines box2d", 2, "--engines");
    expect_refused("render drop --engine custom --out x.png --view round", 2, "overlay");
    expect_refused("check " + test::source("CMakeLists.txt"), 2, "line 1");
    expect_refused("pairs --most 5", 2, "32");
    expect_refused("report", 2, "--out");
    expect_refused("cases perpetuum-mobile", 2, "galperin");
    expect_refused("cases --engine newton", 2, "box2d");
    expect_refused("cases --dt 2", 2, "1e-6");
    expect_refused("bot pinball", 2, "--engine");
    expect_refused("bot toy --engine custom", 2, "rules");
    expect_refused("bot pinball --engine custom --games 0", 2, "--games");
    expect_refused("somersault", 2, "compare");
}

TEST_F(CommandLine, WhatCannotBeDoneIsExitOne) {
    expect_refused("", 1, "DISPLAY is not set");
    environment = "env DISPLAY=:32109";  // where nobody listens
    expect_refused("", 1, "no X server answers");
    expect_refused("render drop --engine custom --out " + file("x.png"), 1, "no X server answers");
}

TEST_F(CommandLine, HelpIsNoError) {
    for (const char* command : {"", "run ", "compare ", "play ", "render ", "check ", "scenes ", "engines ",
                                "pairs ", "cases ", "report ", "bot "}) {
        const Result result = flipside(command + std::string("--help"));
        EXPECT_EQ(result.code, 0) << command;
        EXPECT_NE(result.out.find("Usage"), std::string::npos) << command;
        EXPECT_EQ(result.err, "");
    }
}

TEST_F(CommandLine, ListsSayWhatThereIs) {
    const Result scenes = flipside("scenes");
    for (const char* name : {"bowl", "box", "cradle", "drop", "pinball", "rain", "toy"})
        EXPECT_NE(scenes.out.find(name + std::string("\n")), std::string::npos) << name;
    const Result engines = flipside("engines");
    EXPECT_NE(engines.out.find("motion_iterations = 4  (1 to 64)"), std::string::npos) << engines.out;
}

TEST_F(CommandLine, EveryBadSceneIsRefusedByNameAndEveryGoodOneIsNot) {
    int bad = 0;
    for (const auto& entry : fs::directory_iterator(test::source("tests/world/bad"))) {
        if (!entry.is_regular_file() || (++bad % 4 != 0 && test::in_small)) continue;
        expect_refused("check '" + entry.path().string() + "'", 2, entry.path().filename().string());
    }
    EXPECT_GE(bad, 60);
    for (const char* name : {"bowl", "box", "cradle", "drop", "pinball", "rain", "toy"})
        expect_good("check " + std::string(name));
}

TEST_F(CommandLine, ATrajectoryHasItsColumnsAndEndsOnTime) {
    expect_good("run drop --engine custom --seconds 0.25 --dt 0.1 --every 2 --out " + file("t.csv"));
    EXPECT_EQ(text_of(file("t.csv")).substr(0, 30), "time,ball,x,y,vx,vy,angle,spin");
    const Rows rows = rows_of(file("t.csv"));
    ASSERT_EQ(rows.size(), 3U);  // 0, 0.2 and the shorter step's end
    EXPECT_EQ(rows[0].at("time"), "0");
    EXPECT_EQ(std::stod(rows[2].at("time")), 0.25);
    for (const auto& row : rows) {
        const double t = std::stod(row.at("time"));
        EXPECT_NEAR(std::stod(row.at("y")), 1.0135 - 0.5 * 9.81 * t * t, 1e-12);
        EXPECT_NEAR(std::stod(row.at("vy")), -9.81 * t, 1e-12);
    }
}

TEST_F(CommandLine, TheFirstBounceIsAnEventAndAFigure) {
    for (const std::string engine : {"custom", "box2d"}) {
        expect_good("run drop --engine " + engine + " --seconds 0.6 --events " + file("e.csv") + " --stats " +
                    file("s.json"));
        const Rows rows = rows_of(file("e.csv"));
        ASSERT_FALSE(rows.empty());
        EXPECT_EQ(rows[0].at("kind"), "impact");
        EXPECT_EQ(rows[0].at("other"), "floor");
        EXPECT_NEAR(std::stod(rows[0].at("time")), std::sqrt(2 / 9.81), 1.0 / 60);
        EXPECT_NEAR(std::stod(rows[0].at("ny")), 1, 1e-6);
        const auto stats = nlohmann::json::parse(text_of(file("s.json")));
        for (const char* key : {"steps", "balls", "sim_seconds", "step_seconds", "pair_tests", "narrow_tests",
                                "contacts", "impacts", "energy_first", "energy_last", "max_penetration",
                                "lost", "allocations", "handed_over"})
            EXPECT_TRUE(stats.contains(key)) << key;
        EXPECT_EQ(stats["steps"], 36);
        EXPECT_EQ(stats["impacts"], 1);
        EXPECT_EQ(stats["allocations"], 0);
        EXPECT_NEAR(stats["energy_first"], 0.08 * 9.81 * 1.0135, 1e-9);
    }
}

TEST_F(CommandLine, ASceneMayBeEmpty) {
    std::ofstream(file("empty.json"))
        << R"({"format": "flipside-scene/1", "name": "empty", "about": "Nothing at all.",
               "bounds": {"min": [0, 0], "max": [1, 1]}, "gravity": [0, 0], "balls": [], "parts": []})";
    for (const std::string engine : {"custom", "box2d"}) {
        expect_good("run " + file("empty.json") + " --engine " + engine + " --out " + file("t.csv"));
        EXPECT_EQ(text_of(file("t.csv")), "time,ball,x,y,vx,vy,angle,spin\n");
    }
    expect_good("compare " + file("empty.json") + " --seconds 0");
}

TEST_F(CommandLine, TheSameRunGivesTheSameBytes) {
    for (const std::string engine : {"custom", "box2d"}) {
        for (const std::string name : {"a", "b"})
            expect_good("run pinball --engine " + engine + " --seconds 8 --out " + file(name + ".csv") +
                        " --events " + file(name + "-events.csv") + " --save " + file(name + ".json"));
        for (const std::string ending : {".csv", "-events.csv", ".json"}) {
            EXPECT_GT(text_of(file("a" + ending)).size(), 100U);
            EXPECT_EQ(text_of(file("a" + ending)), text_of(file("b" + ending))) << engine << ending;
        }
    }
}

TEST_F(CommandLine, AStateContinuesOnTheOtherEngineWithoutAJump) {
    constexpr double radius = 0.0135;
    std::ofstream(file("launch.json"))
        << R"({"format": "flipside-script/1", "controls": [{"time": 4.5, "control": "launch"}]})";
    const std::string table = "run pinball --script " + file("launch.json");
    for (const auto& [one, other] : {std::pair("custom", "box2d"), std::pair("box2d", "custom")}) {
        expect_good(table + " --seconds 5 --engine " + one + " --out " + file("a.csv") + " --save " +
                    file("s.json"));
        expect_good(table + " --seconds 1 --engine " + other + " --from " + file("s.json") + " --out " +
                    file("b.csv"));
        const auto before = rows_of(file("a.csv")).back();
        const Rows after = rows_of(file("b.csv"));
        ASSERT_EQ(after.size(), 61U);
        EXPECT_NEAR(std::stod(after.front().at("time")), 5, 1e-12);
        EXPECT_NEAR(std::stod(after.back().at("time")), 6, 1e-12);
        for (const char* key : {"x", "y"})
            EXPECT_NEAR(std::stod(after.front().at(key)), std::stod(before.at(key)), 1e-6 * radius);
        for (const char* key : {"vx", "vy"})
            EXPECT_NEAR(std::stod(after.front().at(key)), std::stod(before.at(key)), 1e-6 * radius);
    }
}

TEST_F(CommandLine, AHandOverToTheSameEngineIsNoHandOverAtAll) {
    expect_good("run pinball --seconds 6 --engine custom --out " + file("whole.csv"));
    expect_good("run pinball --seconds 3 --engine custom --save " + file("s.json"));
    expect_good("run pinball --seconds 3 --engine custom --from " + file("s.json") + " --out " +
                file("rest.csv"));
    auto expected = rows_of(file("whole.csv")).back(), found = rows_of(file("rest.csv")).back();
    expected.erase("time");  // 6 against 3.0000000000000004 + 3
    found.erase("time");
    EXPECT_EQ(found, expected);
}

TEST_F(CommandLine, SettingsWithoutEffectAreToldAndTheRunIsMade) {
    const auto told = [&](const std::string& arguments) {
        const Result result = flipside(arguments);
        EXPECT_EQ(result.code, 0) << arguments << result.err;
        return result.err;
    };
    const std::string note = ": motion_iterations has no effect here, only with solver simple\n";
    const std::string set = " --set motion_iterations=8", custom = " --seconds 0.1 --engine custom";
    EXPECT_EQ(told("run drop" + custom + set), "flipside: custom" + note);
    EXPECT_EQ(told("run drop" + custom + set + " --set solver=simple"), "");
    EXPECT_EQ(told("trace drop --at 0 --engine custom" + set), "flipside: custom" + note);
    EXPECT_EQ(told("compare drop --seconds 0.1 --set custom.motion_iterations=8 --contender a=custom "
                   "--contender b=custom,solver=simple"),
              "flipside: a" + note);
    EXPECT_EQ(told("compare drop --seconds 0.1 --contender a=custom,motion_iterations=8 --contender b=box2d"),
              "flipside: a" + note);
}

TEST_F(CommandLine, AStateOfATableOfAnotherSizeIsRefused) {
    expect_good("run rain --balls 1000 --seconds 0.1 --engine custom --save " + file("s.json"));
    expect_good("run rain --balls 1000 --seconds 0.1 --engine box2d --from " + file("s.json"));
    expect_refused("run rain --seconds 0.1 --engine custom --from " + file("s.json"), 2, "s.json: /table: ");
    expect_refused("trace rain --at 1 --engine custom --from " + file("s.json"), 2, "s.json: /table: ");
    expect_refused("certify rain --out " + file("c.json") + " --from " + file("s.json"), 2,
                   "s.json: /table: ");
    EXPECT_FALSE(fs::exists(file("c.json")));
}

TEST_F(CommandLine, AComparisonSaysWhereTheEnginesPart) {
    const Result result =
        flipside("compare pinball --engines custom,box2d --seconds 10 --json " + file("c.json"));
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("First impact where they part"), std::string::npos);
    EXPECT_NE(result.err.find("pinball.script.json"), std::string::npos);
    const auto json = nlohmann::json::parse(text_of(file("c.json")));
    ASSERT_EQ(json["engines"].size(), 2U);
    EXPECT_EQ(json["engines"][1]["engine"], "box2d");
    EXPECT_EQ(json["engines"][0]["steps"], 600);
    EXPECT_GT(json["engines"][0]["cpu_seconds_per_step"], 0);
    const auto& pair = json["pairs"].at(0);
    EXPECT_EQ(pair["radii_apart"].size(), 600U);
    EXPECT_TRUE(pair["first_parting"].contains("custom"));
    EXPECT_TRUE(pair["first_parting"].contains("box2d"));
    EXPECT_GT(pair["contacts_in_same_order"], 0);
    EXPECT_NE(result.out.find("Blame: the first wrong decision of each"), std::string::npos);
    const auto& blame = json["engines"][1]["blame"]["divergence"];
    EXPECT_GT(blame["radii"], 1);
    EXPECT_NE(blame["fault"], "unknown");
    EXPECT_LE(blame["time"], json["engines"][1]["blame"]["until"]);
    EXPECT_NE(result.out.find(blame["says"].get<std::string>()), std::string::npos);
}

TEST_F(CommandLine, ATraceTellsAStepStageByStage) {
    const Result text = flipside("trace toy --engine custom --set solver=simple --at 0.5");
    EXPECT_EQ(text.code, 0) << text.err;
    std::size_t at = 0;
    for (const char* stage : {"move", "broad phase", "narrow phase", "response", "read-out"}) {
        at = text.out.find(stage, at);
        EXPECT_NE(at, std::string::npos) << stage;
    }
    for (const char* engine : {"custom", "box2d", "reference"}) {
        const std::string json = file(std::string(engine) + ".json");
        expect_good("trace pinball --at 1.5 --engine " + std::string(engine) + " --json " + json);
        const auto trace = nlohmann::json::parse(text_of(json));
        EXPECT_EQ(trace["engine"], engine);
        EXPECT_NEAR(trace["time"].get<double>(), 1.5, 1e-12);
        EXPECT_EQ(trace["stages"].back()["name"], "read-out");
        EXPECT_EQ(trace["stages"].back()["items"][0]["ball"], 0);
    }
    expect_refused("trace toy --engine custom --at 0 --script none --ball 77", 2, "no such ball");
    expect_refused("trace toy --engine custom --at -1", 2, "--at");
    expect_refused("trace toy --at 1", 2, "--engine");
}

TEST_F(CommandLine, LessonsAreListedAndChecked) {
    const Result list = flipside("lessons");
    EXPECT_EQ(list.code, 0) << list.err;
    EXPECT_NE(list.out.find("01-one-frame"), std::string::npos);
    EXPECT_GE(std::ranges::count(list.out, '\n'), 10);
    const Result checked = flipside("lessons 8 --check");
    EXPECT_EQ(checked.code, 0) << checked.out;
    EXPECT_NE(checked.out.find("holds"), std::string::npos);
    expect_refused("lessons nonsense", 2, "01-one-frame");
    expect_refused("lessons " + file("out") + " --check", 2, "not JSON");
}

TEST_F(CommandLine, AReportNeedsGnuplotAndSaysSoBeforeItMeasures) {
    const int status = std::system(("env PATH=" + file("none") + " " + std::string(test::flipside_program) +
                                    " report --quick --out " + file("report") + " 2> " + file("err"))
                                       .c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_NE(text_of(file("err")).find("gnuplot-nox"), std::string::npos) << text_of(file("err"));
    EXPECT_EQ(std::ranges::count(text_of(file("err")), '\n'), 1);
    EXPECT_FALSE(fs::exists(file("report")));
}

TEST_F(CommandLine, AReportThatIsInterruptedLeavesWholeFilesAndGoesOn) {
    const std::string out = file("report");
    const pid_t child = fork();
    if (child == 0) {
        execl(test::flipside_program, "flipside", "report", "--quick", "--out", out.c_str(), nullptr);
        _exit(127);
    }
    const auto measured = [&] {
        std::error_code none;
        const auto files = fs::directory_iterator(out + "/data", none);
        return none ? 0 : std::distance(begin(files), end(files));
    };
    // One of the five may be under way.
    for (int i = 0; i < 3000 && measured() < 5; ++i) usleep(1000);
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
    EXPECT_FALSE(fs::exists(out + "/index.html"));
    ASSERT_GE(measured(), 4);
    for (const auto& entry : fs::recursive_directory_iterator(out + "/data")) {
        if (entry.is_directory()) continue;
        EXPECT_TRUE(entry.path().extension() == ".csv" || entry.path().extension() == ".json")
            << entry.path();
        EXPECT_EQ(text_of(entry.path()).back(), '\n') << entry.path();
    }
    expect_refused("report --out " + out, 2, "report.json");  // not --quick
}

TEST_F(CommandLine, CasesGiveATableAndAFileAndExitOneWhereOneFails) {
    const Result passed =
        flipside("cases galperin 9 --quick --set solver=continuous --json " + file("cases.json"));
    EXPECT_EQ(passed.code, 0);
    EXPECT_NE(passed.out.find("collisions, M/m = 100^3"), std::string::npos);
    EXPECT_NE(passed.out.find("2 cases: 2 pass"), std::string::npos);
    const auto json = nlohmann::json::parse(text_of(file("cases.json")));
    EXPECT_EQ(json["cases"].size(), 2U);
    EXPECT_EQ(json["settings"]["solver"], "continuous");
    // A ball of a million radii per second is past the wall in one step of the toy.
    const Result failed = flipside("cases thin-wall --set solver=simple");
    EXPECT_EQ(failed.code, 1);
    EXPECT_NE(failed.out.find("1 cases: 1 fail"), std::string::npos);
    EXPECT_EQ(flipside("cases --engine box2d --map " + file("map.csv")).code, 0);
    EXPECT_EQ(rows_of(file("map.csv")).size(), 216U);
}

TEST_F(CommandLine, NothingThatIsAskedForIsIgnored) {
    const std::string json = " --json " + file("cases.json");
    for (const std::string& other :
         std::vector<std::string>{" 1", " --engine box2d", " --set substeps=4", " --quick", json}) {
        expect_refused("cases --hard" + other, 2, "--hard takes no ");
        expect_refused("cases --list" + other, 2, "--list takes no ");
    }
    for (const std::string& other : std::vector<std::string>{" 1", " --dt 1/120", " --quick", json})
        expect_refused("cases --map map.csv" + other, 2, "--map takes no ");
    expect_refused("cases --map map.csv 1", 2, "it is given alone or with --engine, --set");
    expect_refused("sweep --contenders custom-simple,custom-simple --out " + file("sweep"), 2, "there twice");
    EXPECT_FALSE(fs::exists(file("sweep")));
    expect_refused("run drop --engine custom --every 5", 2, "--every requires --out");
    for (const std::string list : {"custom,,box2d", "custom,box2d,", ",custom"}) {
        expect_refused("compare drop --engines " + list, 2, "--engines: '" + list + "' has an empty item");
        expect_refused("sweep --out " + file("sweep") + " --contenders=" + list, 2, "has an empty item");
    }
    // As an unset variable of a shell gives them.
    expect_refused("run drop --engine custom --seconds 1 --save ''", 2, "argument 8 is empty (--save)");
    expect_refused("run drop --engine custom --seconds 1 --from=", 2, "argument 7 is empty (--from=)");
    expect_refused("''", 2, "argument 1 is empty");
}

TEST_F(CommandLine, WholeNumbersAreWrittenInDigits) {
    const std::string run = "run drop --engine custom --seconds 1 --every ";
    for (const char* every : {"1.5", "1e3", "0", "-1", "12345678901234567890", "0x10", "010"})
        expect_refused(run + every, 2, "it takes a whole number from 1 to 1000000000");
    expect_refused("trace drop --engine custom --ball -1", 2, "a whole number from 0 to 4294967295");
    expect_refused("hunt --engine custom --out x --seed 1e3", 2, "a whole number from 0 to 1000000000000");
}

TEST_F(CommandLine, NumbersAreDecimalAndTimesNotTooShortForAStep) {
    for (const char* seconds : {"0x10", "1e8", "-1", "inf", "nan", "1s", "1,5"})
        expect_refused("run drop --engine custom --seconds " + std::string(seconds), 2,
                       "it takes a number from 0 to 10000000");
    expect_refused("run drop --engine custom --seconds 1e-12 --out " + file("t.csv"), 2,
                   "it takes 0, or a number from 1e-08");
    EXPECT_FALSE(fs::exists(file("t.csv")));
    expect_good("run drop --engine custom --seconds 1e-8 --out " + file("t.csv"));
    EXPECT_EQ(rows_of(file("t.csv")).back().at("time"), "1e-08");
}

TEST_F(CommandLine, AnInterruptLeavesNoFile) {
    const std::string out = file("t.csv");
    const pid_t child = fork();
    if (child == 0) {
        execl(test::flipside_program, "flipside", "run", "box", "--engine", "custom", "--seconds", "100000",
              "--every", "100", "--out", out.c_str(), nullptr);
        _exit(127);
    }
    const auto started = [&] {  // the file under way is there: the run has begun
        return fs::directory_iterator(folder) != fs::directory_iterator();
    };
    for (int i = 0; i < 500 && !started(); ++i) usleep(10000);
    ASSERT_TRUE(started());
    usleep(100000);
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
    EXPECT_FALSE(started());
}

}  // namespace
}  // namespace flipside::app
