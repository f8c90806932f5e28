/// Where what the program has to say cannot go: stdout that is full or closed, files that are inputs or
/// written twice, paths that are no paths. Nothing is lost without an exit code and one line.

#include "command_line.hpp"
#include "places.hpp"

namespace flipside::app {
namespace {

/// Commands that print, each as short as can be.
const std::vector<std::string> printing = {"run drop --engine custom --seconds 0",
                                           "compare drop --seconds 0",
                                           "cases zeno-drop --quick",
                                           "cases --list",
                                           "pairs --seconds 0.1 --most 32",
                                           "scenes",
                                           "engines",
                                           "check drop",
                                           "--help",
                                           "run --help",
                                           "--version"};

TEST_F(CommandLine, AFullStdoutIsExitOneAndOneLine) {
    for (const std::string& arguments : printing)
        expect_refused(flipside(arguments, "> /dev/full"), arguments, 1,
                       "standard output: cannot be written (No space left on device)");
}

TEST_F(CommandLine, AClosedStdoutIsExitOneAndOneLine) {
    for (const std::string& arguments : printing)
        expect_refused(flipside(arguments, ">&-"), arguments, 1, "standard output: cannot be written");
    // What prints nothing needs none, and no file takes its place.
    const Result quiet = flipside("run drop --engine custom --seconds 0 --out " + file("t.csv"), ">&-");
    EXPECT_EQ(quiet.code, 0) << quiet.err;
    EXPECT_EQ(text_of(file("t.csv")).substr(0, 5), "time,");
    EXPECT_EQ(flipside("scenes", "<&-").code, 0);
    EXPECT_EQ(flipside("run nowhere --engine custom", "2>&-").code, 2);
}

TEST_F(CommandLine, APipeThatNobodyReadsIsExitOneAndOneLine) {
    // The reader has gone by the time that there is something to read.
    const std::string line = "{ sleep 0.2; " + std::string(test::flipside_program) + " engines 2> " +
                             file("err") + "; echo $? > " + file("code") + "; } | true";
    ASSERT_EQ(std::system(line.c_str()), 0);
    EXPECT_EQ(text_of(file("code")), "1\n");
    EXPECT_EQ(text_of(file("err")), "flipside: standard output: cannot be written (Broken pipe)\n");
}

TEST_F(CommandLine, AFileThatGrowsPastItsLimitIsExitOneAndLeavesNothing) {
    environment = "ulimit -f 8; env -u DISPLAY";  // blocks of 512 bytes
    const std::string run = "run box --engine custom --seconds 10 --out " + file("t.csv");
    expect_refused(run, 1, "t.csv: cannot be written (File too large)");
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_TRUE(entry.path().filename() == "out" || entry.path().filename() == "err") << entry.path();
}

class OutputFiles : public CommandLine {
  protected:
    static constexpr const char* scene =
        R"({"format": "flipside-scene/1", "name": "empty", "bounds": {"min": [0, 0], "max": [1, 1]}})";
    static constexpr const char* controls = R"({"format": "flipside-script/1", "controls": []})";

    void SetUp() override {
        CommandLine::SetUp();
        std::ofstream(file("scene.json")) << scene;
        std::ofstream(file("controls.json")) << controls;
        expect_good(run + "--save " + file("state.json"));
        fs::create_hard_link(file("scene.json"), file("hard"));
        fs::create_symlink(file("controls.json"), file("soft"));
        fs::create_symlink("soft", file("softer"));
        fs::create_symlink("new.csv", file("dangling"));
        fs::create_directory_symlink(folder, file("around"));
    }
    std::string run =
        "run " + file("scene.json") + " --engine custom --seconds 0 --script " + file("controls.json") + " ";
    const std::string same_state = "--from " + file("state.json") + " ";

    void expect_untouched() const {
        EXPECT_EQ(text_of(file("scene.json")), scene);
        EXPECT_EQ(text_of(file("controls.json")), controls);
    }
};

TEST_F(OutputFiles, MayNotBeInputsWhateverTheyAreCalled) {
    for (const char* option : {"--out ", "--events ", "--stats ", "--save "})
        for (const std::string& input :
             {file("scene.json"), file("./scene.json"), file("hard"), file("around/scene.json"),
              file("controls.json"), file("soft"), file("softer"), file("state.json")})
            expect_refused(run + same_state + option + input, 2, ", which is read");
    expect_refused("compare " + file("scene.json") + " --seconds 0 --json " + file("hard"), 2,
                   "which is read");
    expect_refused("play " + file("scene.json") + " --report " + file("hard"), 2, "which is read");
    expect_refused("render " + file("scene.json") + " --engine custom --out " + file("hard"), 2,
                   "which is read");
    fs::create_directory(file("swept"));
    fs::copy_file(file("scene.json"), file("swept/plan.json"));
    expect_refused("sweep " + file("swept/plan.json") + " --quick --out " + file("swept"), 2,
                   "which is read");
    // The script beside the scene is an input that nobody named.
    fs::copy_file(file("controls.json"), file("scene.script.json"));
    expect_refused("run " + file("scene.json") + " --engine custom --out " + file("scene.script.json"), 2,
                   "the script");
    expect_untouched();
}

TEST_F(OutputFiles, MayNotBeOneAndTheSame) {
    const std::pair<std::string, std::string> pairs[] = {{file("a.csv"), file("a.csv")},
                                                         {file("a.csv"), file("./a.csv")},
                                                         {file("a.csv"), file("around/a.csv")},
                                                         {file("new.csv"), file("dangling")},
                                                         {file("out"), "/dev/stdout"}};
    for (const auto& [one, other] : pairs)
        expect_refused(run + "--out " + one + " --events " + other, 2, "which is written too");
    EXPECT_FALSE(fs::exists(file("a.csv")));
    expect_good(run + "--out /dev/null --events /dev/null");
    expect_good(run + "--out /dev/stdout --stats " + file("stats.json"));
    expect_good(run + "--out " + file("dangling"));
    EXPECT_TRUE(fs::is_symlink(file("dangling")) && fs::exists(file("new.csv")));
    // A table on stdout would be written over the file, or the file over the table.
    const std::string compare = "compare " + file("scene.json") + " --seconds 0 --json ";
    expect_refused(compare + "/dev/stdout", 2, "stdout");
    expect_refused(compare + file("out"), 2, "stdout");
    expect_refused("cases --json a --map b", 2, "--map");
}

/// Commands with the option of a file, each as short as can be.
const std::vector<std::string> writing = {"run drop --engine custom --seconds 0 --out ",
                                          "run drop --engine custom --seconds 0 --events ",
                                          "run drop --engine custom --seconds 0 --stats ",
                                          "run drop --engine custom --seconds 0 --save ",
                                          "run drop --engine custom --seconds 0 --replay ",
                                          "compare drop --seconds 0 --json ",
                                          "cases zeno-drop --quick --json ",
                                          "cases --engine custom --map ",
                                          "pairs --seconds 0.1 --most 32 --json ",
                                          "trace drop --engine custom --at 0 --json ",
                                          "certify drop --seconds 0 --out ",
                                          "bot pinball --engine custom --games 1 --out ",
                                          "render drop --engine custom --out "};

TEST_F(OutputFiles, OfAWrongPathAreBadInput) {
    fs::create_directory(file("folder.png"));
    for (const std::string& arguments : writing) {
        expect_refused(arguments + file("none/x.png"), 2, "cannot be written (No such file or directory)");
        expect_refused(arguments + file("scene.json/x.png"), 2, "cannot be written (Not a directory)");
        expect_refused(arguments + file("folder.png"), 2, "cannot be written (Is a directory)");
    }
    for (const char* arguments : {"sweep drop --quick --out ", "sweep drop --tune custom --quick --out ",
                                  "report --quick --out ", "hunt --engine custom --out "})
        expect_refused(arguments + file("scene.json/x"), 2, "cannot be made (Not a directory)");
    expect_untouched();
}

TEST_F(OutputFiles, OfAWrongPathAreToldBeforeTheRun) {
    // A run that ends at the limit of speeds.
    std::ofstream(file("fast.json")) << R"({"format": "flipside-scene/1", "name": "fast", "balls": [
        {"position": [0, 9e8], "radius": 1, "mass": 1}], "gravity": [0, -1e9],
        "bounds": {"min": [-1e9, -1e9], "max": [1e9, 1e9]}})";
    const std::string fast = "run " + file("fast.json") + " --engine custom --seconds 2";
    expect_refused(fast, 1, "top speed");
    const auto before = std::distance(fs::directory_iterator(folder), {});
    for (const char* option : {" --out ", " --events ", " --stats ", " --save ", " --replay "}) {
        expect_refused(fast + option + file("none/x"), 2, "none/x: cannot be written");
        expect_refused(fast + option + file("x"), 1, "top speed");
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), before) << "something was left behind";
}

TEST_F(OutputFiles, MayHaveNamesOf250Characters) {
    const std::string name(250, 'n');
    expect_good(run + "--out " + file(name));
    EXPECT_EQ(text_of(file(name)).substr(0, 5), "time,");
    fs::copy_file(file("scene.json"), file("s" + name));
    fs::copy_file(file("controls.json"), file("c" + name));
    fs::copy_file(file("state.json"), file("f" + name));
    expect_good("run " + file("s" + name) + " --engine custom --seconds 0 --script " + file("c" + name) +
                " --from " + file("f" + name) + " --save " + file("t" + name));
    expect_good("check " + file("s" + name));
    expect_good("compare " + file("s" + name) + " --seconds 0 --json " + file("j" + name));
}

TEST_F(OutputFiles, AndInputsOfTooLongANameAreBadInput) {
    for (const std::string& path : {file(std::string(256, 'n')), file(std::string(5000, 'n'))}) {
        const std::string too_long = "File name too long";
        for (const char* option : {"--out ", "--events ", "--stats ", "--save ", "--from "})
            expect_refused(run + option + path, 2, too_long);
        expect_refused("run drop --engine custom --script " + path, 2, too_long);
        expect_refused("check " + path, 2, too_long);
        expect_refused(path, 2, too_long);
        expect_refused("play " + path, 2, too_long);
        expect_refused("compare drop --seconds 0 --json " + path, 2, too_long);
        expect_refused("cases --set solver=continuous --map " + path, 2, too_long);
        expect_refused("sweep drop --quick --out " + path, 2, too_long);
        expect_refused("report --quick --out " + path, 2, too_long);
        expect_refused("report --quick --out " + file("r") + " --from " + path, 2, too_long);
    }
    fs::create_symlink("loop", file("loop"));
    expect_refused("check " + file("loop"), 2, "Too many levels of symbolic links");
    expect_refused(run + "--out " + file("loop"), 2, "Too many levels of symbolic links");
}

TEST_F(OutputFiles, AndInputsInForbiddenFoldersAreBadInput) {
    fs::create_directory(file("closed"));
    fs::copy_file(file("scene.json"), file("closed/scene.json"));
    fs::permissions(file("closed"), fs::perms::none);
    if (geteuid() == 0) {  // whom nothing is forbidden
        for (const auto& entry : fs::directory_iterator(folder))
            ASSERT_EQ(lchown(entry.path().c_str(), 65534, 65534), 0);
        ASSERT_EQ(chown(folder.c_str(), 65534, 65534), 0);
        environment = "setpriv --reuid 65534 --clear-groups env -u DISPLAY";
    }
    const std::string inside = file("closed/scene.json"), denied = "Permission denied";
    expect_refused("check " + inside, 2, denied);
    expect_refused("play " + inside, 2, denied);
    expect_refused(run + "--out " + inside, 2, denied);
    expect_refused("run drop --engine custom --script " + inside, 2, denied);
    expect_refused(run + "--from " + inside, 2, denied);
    expect_refused("sweep drop --quick --out " + file("closed/sweep"), 2, denied);
    expect_refused("report --quick --out " + file("closed/report"), 2, denied);
    expect_refused("report --quick --out " + file("report") + " --from " + file("closed"), 2, denied);
    fs::permissions(file("closed"), fs::perms::owner_all);
    fs::permissions(inside, fs::perms::none);
    expect_refused("check " + inside, 2, denied);
}

}  // namespace
}  // namespace flipside::app
