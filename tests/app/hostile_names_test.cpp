/// Names from files and arguments that a terminal, a shell, a page, a spreadsheet or a path would take for
/// more than names, through everything that the commands write.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "in_small.hpp"
#include "lab/files/csv_table.hpp"

namespace flipside::app {
namespace {

using Json = nlohmann::json;

/// What JSON can hold.
const std::vector<std::string> hostile = {"<script>alert(1)</script>",
                                          "../../x",
                                          "a\nflipside: forged",
                                          "\x1b[31mred\x1b]0;title\a",
                                          "=1+1",
                                          "+1",
                                          "-1",
                                          "@SUM(1)",
                                          "\x7f\b\r",
                                          "\u009b31m\u0085",
                                          "\u202egnp.exe\u2066",
                                          "a,\"b\";'c'",
                                          "`touch RUN` $(touch RUN) %s%n"};
/// What names of files and arguments can hold.
std::vector<std::string> hostile_bytes() {
    std::vector<std::string> all = hostile;
    for (const char* bytes : {"\xff\xfe",
                              "\x9b"
                              "31m",
                              "\xc0\x8a"})
        all.emplace_back(bytes);
    return all;
}

class HostileNames : public CommandLine {
  protected:
    /// One word of a shell's line.
    static std::string word(const std::string& bytes) {
        std::string out = "'";
        for (const char c : bytes) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
        return out + "'";
    }

    /// Names of parts go into CSV files and are limited.
    static bool may_name_a_part(const std::string& name) {
        return std::ranges::all_of(name, [](char c) { return c >= ' ' && c < 0x7f && c != ',' && c != '"'; });
    }

    /// A ball falls on a part; all that has a name has this one, the part as far as it may.
    static std::string scene_named(const std::string& name) {
        return Json{{"format", "flipside-scene/1"},
                    {"name", name},
                    {"about", name},
                    {"bounds", {{"min", {-1, -1}}, {"max", {1, 1}}}},
                    {"gravity", {0, -10}},
                    {"materials", {{name, {{"restitution", 0.5}}}}},
                    {"balls",
                     {{{"position", {0, 0.2}},
                       {"radius", 0.1},
                       {"mass", 1},
                       {"material", name},
                       {"layer", name},
                       {"collides_with", {name}}},
                      {{"position", {0, 0.25}}, {"radius", 0.1}, {"mass", 1}, {"layer", name}}}},
                    {"parts",
                     {{{"name", may_name_a_part(name) ? name : "part"},
                       {"material", name},
                       {"layer", name},
                       {"collides_with", {name}},
                       {"shape", {{"type", "circle"}, {"center", {0, -0.2}}, {"radius", 0.2}}}}}}}
            .dump();
    }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
        return word((folder / name).string());
    }
    /// Ends with 0, or with `code` and one line.
    Result expect_ends(const std::string& arguments, int code) const {
        Result result = flipside(arguments);
        EXPECT_EQ(result.code, code) << arguments << ": " << result.err;
        if (code != 0) {
            EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << arguments << ": " << result.err;
        }
        if (code == 2) {
            EXPECT_EQ(result.out, "") << arguments;
        }
        return result;
    }
    /// The fields of a column, none of which has a comma in it, as they stand in the file.
    static std::vector<std::string> raw_column(const std::string& csv, std::size_t column) {
        std::vector<std::string> fields;
        std::istringstream lines(csv);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream rest(line);
            std::string field;
            for (std::size_t i = 0; i <= column; ++i) std::getline(rest, field, ',');
            fields.push_back(field);
        }
        return fields;
    }
    /// ASCII and JSON.
    static Json json_in(const fs::path& file) {
        const std::string text = text_of(file);
        for (const char c : text) EXPECT_TRUE((c >= ' ' && c < 0x7f) || c == '\n') << file;
        return Json::parse(text);
    }
};

TEST_F(HostileNames, OfASceneReachNoOutputAsTheyAre) {
    for (const std::string& name : hostile) {
        const std::string scene = write("scene.json", scene_named(name));
        const Result checked = expect_ends("check " + scene, 0);
        EXPECT_EQ(std::ranges::count(checked.out, '\n'), 2) << checked.out;  // good, and balls that overlap
        expect_ends("run " + scene + " --engine custom --seconds 0.5 --out " + file("t.csv") + " --events " +
                        file("e.csv") + " --stats " + file("s.json") + " --save " + file("state.json"),
                    0);
        expect_no_commands(text_of(file("e.csv")), name);
        const lab::CsvTable events(file("e.csv"));
        EXPECT_EQ(events.rows() + 1,
                  static_cast<std::size_t>(std::ranges::count(text_of(file("e.csv")), '\n')));
        for (const std::string& other : raw_column(text_of(file("e.csv")), 3))
            EXPECT_NE(other.find_first_of("=+-@"), 0U) << other;
        bool met = false;
        for (std::size_t row = 0; row < events.rows(); ++row)
            met |= events.text(row, "other") == (may_name_a_part(name) ? name : "part");
        EXPECT_TRUE(met);
        EXPECT_EQ(json_in(file("state.json"))["scene"], name);
        expect_ends("run " + scene + " --engine box2d --seconds 0.1 --from " + file("state.json") +
                        " --out " + file("t.csv"),
                    0);
        const Result compared = expect_ends("compare " + scene + " --seconds 1 --json " + file("c.json"), 0);
        EXPECT_EQ(compared.out.find("\nflipside: forged"), std::string::npos);
        EXPECT_EQ(json_in(file("c.json"))["scene"], name);
        if (name.find("touch") == std::string::npos) continue;
        EXPECT_FALSE(fs::exists("RUN"));
    }
}

TEST_F(HostileNames, OfASceneAreRefusedForASweep) {
    for (const std::string& name : hostile) {
        const std::string scene = write("scene.json", scene_named(name));
        expect_refused("sweep " + scene + " --quick --out " + file("swept"), 2, "/name");
        EXPECT_FALSE(fs::exists(file("swept")));
    }
}

TEST_F(HostileNames, InErrorsOfFilesStayInOneLine) {
    for (const std::string& name : hostile) {
        const Json scene = Json::parse(scene_named("plain"));
        const auto refused = [&](const Json& json) {
            expect_ends("check " + write("bad.json", json.dump()), 2);
        };
        Json bad = scene;
        bad[name] = 1;
        refused(bad);
        if (!may_name_a_part(name)) {
            bad = scene;
            bad["parts"][0]["name"] = name;
            refused(bad);
        }
        bad = scene;
        bad["balls"][0]["material"] = name;
        refused(bad);
        bad = scene;
        bad["recommend"]["custom"][name] = name;
        refused(bad);
        bad = scene;
        bad["recommend"]["run"]["dt"] = name;
        refused(bad);
        bad = scene;
        bad["parts"][0]["shape"]["type"] = name;
        refused(bad);
        bad = scene;
        bad["format"] = name;
        refused(bad);
        const std::string good = write("good.json", scene.dump());
        const std::string script =
            Json{{"format", "flipside-script/1"}, {"controls", {{{"time", 0}, {"control", name}}}}}.dump();
        expect_ends("run " + good + " --engine custom --script " + write("bad.json", script), 2);
        const std::string state = Json{{"format", "flipside-state/1"}, {"scene", name}, {name, name}}.dump();
        expect_ends("run " + good + " --engine custom --from " + write("bad.json", state), 2);
        expect_ends("check " + write("bad.json", name), 2);
        expect_ends("check " + write("bad.json", "{\"" + name + "\": \xff}"), 2);
    }
}

TEST_F(HostileNames, OfArgumentsStayInOneLine) {
    std::size_t tried = 0;
    for (const std::string& name : hostile_bytes()) {
        const std::string bad = word(name), option = word("--" + name);
        for (const std::string& arguments : {bad,
                                             "play " + bad,
                                             "run " + bad + " --engine custom",
                                             "run drop --engine " + bad,
                                             "run drop --engine custom --set " + bad,
                                             "run drop --engine custom --set " + word(name + "=1"),
                                             "run drop --engine custom --set " + word("solver=" + name),
                                             "run drop --engine custom --dt " + bad,
                                             "run drop --engine custom --seconds " + word("x" + name),
                                             "run drop --engine custom --from " + bad,
                                             "run drop --engine custom --script " + bad,
                                             "run drop --engine custom " + option,
                                             "check " + bad,
                                             "compare " + bad,
                                             "compare drop --engines custom," + bad,
                                             "cases " + bad,
                                             "cases --engine " + bad,
                                             "sweep " + bad + " --out x",
                                             "sweep drop --quick --out x --shard " + word("x" + name),
                                             "sweep drop --quick --out x --contenders " + bad,
                                             "report --out " + file("r") + " --from " + bad,
                                             "render drop --engine custom --out x.png --view " + bad,
                                             "render drop --engine custom --out " + bad,
                                             "pairs --most " + word("x" + name)})
            if (!test::in_small || ++tried % 5 == 0) expect_ends(arguments, 2);
        if (name.find(':') != std::string::npos) continue;  // before which stands a host to ask for
        environment = "env DISPLAY=" + bad;
        expect_ends("play drop", 1);
        environment = "env -u DISPLAY";
    }
    EXPECT_FALSE(fs::exists("RUN"));
}

TEST_F(HostileNames, OfFilesAreReadAndWrittenAsTheyAre) {
    const std::string plain = scene_named("plain");
    int files = 0;
    for (std::string name : hostile_bytes()) {
        std::ranges::replace(name, '/', '_');
        const std::string scene = write(name + ".json", plain);
        write(name + ".script.json", R"({"format": "flipside-script/1", "controls": []})");
        expect_ends("check " + scene, 0);
        const Result run =
            expect_ends("run " + scene + " --engine custom --seconds 0 --out " + word(file(name + ".csv")) +
                            " --save " + word(file(name + ".state")),
                        0);
        EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;  // the script beside the scene
        EXPECT_TRUE(fs::exists(file(name + ".csv")) && fs::exists(file(name + ".state")));
        expect_ends(
            "run " + scene + " --engine custom --seconds 0 --script none --out " + word(file(name + "/none")),
            2);
        expect_ends("report --out " + word(file(name + ".csv")), 2);  // a file, not a folder
        ++files;
    }
    EXPECT_EQ(files, 16);
}

TEST_F(HostileNames, OfScenesInTheirFolderAreListedInALineEach) {
    fs::create_directories(folder / "scenes");
    std::size_t scenes = 0;
    for (std::string name : hostile_bytes()) {
        std::ranges::replace(name, '/', '_');
        if (name.find('.') != std::string::npos) continue;  // NAME.script.json is no scene
        write("scenes/" + name + ".json", scene_named(hostile[scenes % hostile.size()]));
        ++scenes;
    }
    environment = "env -u DISPLAY FLIPSIDE_ASSETS=" + word(folder.string());
    const Result listed = expect_ends("scenes", 0);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(listed.out, '\n')), 2 * scenes) << listed.out;
    expect_ends("run nowhere --engine custom", 2);
}

TEST_F(HostileNames, InAForeignSweepAreRefusedBeforeAnythingIsMeasured) {
    for (const std::string& name : hostile) {
        const fs::path foreign = folder / "foreign";
        fs::create_directories(foreign / "runs");
        std::string field = "\"";
        for (const char c : name) field.append(c == '"' ? 2 : 1, c);
        write("foreign/plan.json", Json{{"format", name}}.dump() + "\n");
        write("foreign/runs/x-001.csv", "variant,contender\n" + field + "\"," + field + "\"\n");
        expect_refused("report --quick --out " + file("report") + " --from " + file("foreign"), 2,
                       foreign.string());
        EXPECT_FALSE(fs::exists(file("report")));
    }
}

}  // namespace
}  // namespace flipside::app
