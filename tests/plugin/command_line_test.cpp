/// The real executable with a library as its engine.

#ifdef FLIPSIDE_WITH_APP

#include "app/command_line.hpp"

#include "places.hpp"

namespace flipside::app {
namespace {

const std::string engine_in_c = test::engine_in_c, naughty_engine = test::naughty_engine;

TEST_F(CommandLine, ALibraryIsAnEngineEverywhere) {
    const std::string engine = " --engine " + engine_in_c;
    expect_good("run drop --seconds 1 --out " + file("a.csv") + engine);
    expect_good("run drop --seconds 1 --out " + file("b.csv") + engine);
    EXPECT_EQ(text_of(file("a.csv")), text_of(file("b.csv")));
    expect_good("run drop --seconds 0.5 --save " + file("half.json") + engine);
    expect_good("run drop --seconds 0.5 --engine custom --from " + file("half.json"));
    expect_good("trace drop --at 0.4" + engine);
    expect_good("cases zeno-drop --quick --set substeps=4" + engine);
    expect_good("compare box --seconds 1 --engines custom," + engine_in_c + " --set engine-in-c.substeps=4");
    expect_good("compare box --seconds 1 --contender a=" + engine_in_c + ",substeps=2 --contender b=custom");
    EXPECT_NE(flipside("engines " + engine_in_c).out.find("substeps = 8  (1 to 1000)"), std::string::npos);
}

TEST_F(CommandLine, WhatALibraryCannotDoIsSaidInOneLine) {
    expect_refused("run pinball --engine " + engine_in_c, 2, "needs what this engine does not support: arcs");
    expect_refused("run drop --engine ./nowhere.so", 2, "nowhere.so");
    const std::string fifo = file("fifo");
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    expect_refused("run drop --engine " + fifo, 2, "is no regular file");
    // A library is an input, also through a link.
    const std::string copy = file("copy.so"), link = file("link.csv");
    fs::copy_file(engine_in_c, copy);
    fs::create_symlink(copy, link);
    const std::string bytes = text_of(copy);
    for (const std::string command : {"run drop --seconds 0.1 --out ", "trace drop --at 0 --json ",
                                      "compare drop --seconds 0.1 --json ", "cases 1 --json "}) {
        const std::string engine = command.starts_with("compare") ? " --engines custom," : " --engine ";
        expect_refused(command + link + engine + copy, 2, "which is read");
    }
    EXPECT_EQ(text_of(copy), bytes);
    expect_refused("run drop --engine " + test::source("README.md"), 2, "cannot be loaded");
    expect_refused("run drop --set does=crash --engine " + naughty_engine, 1,
                   "custom-2: in the step from 0.1 s");
    expect_refused("run drop --set does=abort --out " + file("none.csv") + " --engine " + naughty_engine, 1,
                   "\\x1b]0;owned");
    EXPECT_FALSE(fs::exists(file("none.csv")));
}

TEST_F(CommandLine, ComparisonsAndSweepsFinishWithoutTheOneThatCrashes) {
    const Result compared = flipside("compare drop --seconds 1 --engines custom," + naughty_engine +
                                     ",box2d --set custom-2.does=crash --json " + file("compare.json"));
    EXPECT_EQ(compared.code, 1);
    EXPECT_NE(compared.out.find("custom-2 ended at 0.1 s: "), std::string::npos) << compared.out;
    EXPECT_NE(compared.out.find("custom and box2d: "), std::string::npos);
    EXPECT_TRUE(fs::exists(file("compare.json")));
    const Result swept = flipside("sweep bowl --quick --finest 60 --contenders custom-continuous," +
                                  engine_in_c + " --out " + file("sweep"));
    EXPECT_EQ(swept.code, 0) << swept.err;
    EXPECT_NE(swept.err.find("engine-in-c: cannot run scene 'bowl'"), std::string::npos) << swept.err;
    EXPECT_TRUE(fs::exists(file("sweep/sweep.csv")));
}

TEST_F(CommandLine, ConformanceIsAnExitCodeAndMarks) {
    const Result good = flipside("conformance " + engine_in_c + " --json " + file("marks.json"));
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_NE(good.out.find("of 100 points; passed"), std::string::npos);
    EXPECT_NE(text_of(file("marks.json")).find("flipside-conformance/1"), std::string::npos);
    expect_refused("conformance " + engine_in_c + " --json " + file("none/x"), 2, "cannot be written");
    EXPECT_EQ(flipside("conformance " + naughty_engine).code, 1);
    EXPECT_EQ(flipside("conformance " + test::source("README.md")).code, 1);
    expect_refused("conformance " + file("nothing.so"), 2, "there is no such file");
}

}  // namespace
}  // namespace flipside::app

#endif
