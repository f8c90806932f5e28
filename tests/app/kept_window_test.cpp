/// What the window keeps between two starts, in the real window and in a folder of the test's own.

#include <fstream>

#include "app/window/kept.hpp"
#include "app/window_fixture.hpp"
#include "lab/files/assets.hpp"

namespace flipside::app {
namespace {

namespace fs = std::filesystem;

class KeptWindow : public WindowTest {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-kept-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        home = name;
    }
    void TearDown() override {
        WindowTest::TearDown();
        fs::permissions(home / "flipside", fs::perms::owner_all, fs::perm_options::add, ignored);
        fs::remove_all(home);
    }
    /// The program as a user starts it.
    void start(const std::vector<std::string>& arguments = {}) {
        if (window) WindowTest::TearDown();
        window = std::make_unique<RealWindow>(arguments, home);
    }
    void end() {
        window->key("Escape");
        EXPECT_EQ(window->program().wait(60), 0);
    }
    [[nodiscard]] fs::path file() const { return home / "flipside" / "window.json"; }
    void write(const std::string& text) const {
        fs::create_directories(file().parent_path());
        std::ofstream(file()) << text;
    }
    [[nodiscard]] std::string text() const {
        std::ifstream in(file());
        return {std::istreambuf_iterator<char>(in), {}};
    }

    fs::path home;
    std::error_code ignored;
};

TEST_F(KeptWindow, TheFirstStartOffersALessonAndTheSecondDoesNot) {
    start();
    Json state = window->now();
    EXPECT_TRUE(state["controls"].contains("Start lesson 1"));
    EXPECT_TRUE(state["controls"].contains("Just play"));
    click("Just play");
    state = window->wait("the table", [](const Json& s) { return s["controls"].contains("Launch"); });
    EXPECT_EQ(state["scene"], "pinball");
    end();
    start();
    state = settled();
    EXPECT_FALSE(state["controls"].contains("Start lesson 1"));
    EXPECT_TRUE(state["controls"].contains("Launch"));
}

TEST_F(KeptWindow, TheOfferOpensTheFirstLesson) {
    start();
    click("Start lesson 1");
    window->wait("the lesson", [](const Json& s) { return s.contains("lesson"); });
    end();
    start();
    window->wait("the same lesson",
                 [](const Json& s) { return s.contains("lesson") && s["lesson"]["name"] == "01-one-frame"; });
}

TEST_F(KeptWindow, WhatWasOnShowIsOnShowAgain) {
    start({"toy", "--width", "1100", "--height", "700", "--scale", "1"});
    click("Boxes");
    click("custom.collision_iterations");
    click("Overlay");
    window->key("g");
    const Json before = window->wait("the next plots", [](const Json& s) {
        return s["view"] == "overlay" && s["plots"] == "Distance and cost";
    });
    end();
    start();
    const Json after = settled();
    for (const char* what : {"scene", "view", "show", "engines", "letters", "panel", "plots"})
        EXPECT_EQ(after[what], before[what]) << what;
    EXPECT_EQ(after["layout"]["window"], before["layout"]["window"]);
}

TEST_F(KeptWindow, TheCommandLineWins) {
    start({"toy", "--view", "overlay"});
    end();
    start({"drop", "--view", "single", "--width", "1000", "--height", "650", "--engine", "box2d"});
    const Json state = window->now();
    EXPECT_EQ(state["scene"], "drop");
    EXPECT_EQ(state["view"], "single");
    EXPECT_EQ(state["panes"][0]["engine"], "box2d");
    EXPECT_EQ(state["layout"]["window"], Json::parse("[1000.0, 650.0]"));
}

TEST_F(KeptWindow, AFaultyFileIsLeftAloneAndSaidOnce) {
    for (const std::string faulty :
         {"{\"format\": ", "[1, 2]", "{\"format\": \"another-program/7\"}", "\xff\xfe"}) {
        write(faulty);
        start();
        const Json state = window->now();
        EXPECT_EQ(state["scene"], "pinball");
        EXPECT_NE(state["notice"].get<std::string>().find("window.json"), std::string::npos)
            << state["notice"];
        click("I see");
        window->wait("it to be read", [](const Json& s) { return s["notice"] == ""; });
        click("Boxes");
        end();
        EXPECT_EQ(text(), faulty);
    }
}

TEST_F(KeptWindow, ASceneThatIsGoneStopsNothing) {
    const fs::path scene = home / "mine.json";
    fs::copy_file(lab::scene_file("drop"), scene);
    start({scene.string()});
    end();
    EXPECT_NE(text().find("mine.json"), std::string::npos);
    fs::remove(scene);
    start();
    const Json state = window->now();
    EXPECT_EQ(state["scene"], "pinball");
    EXPECT_NE(state["notice"].get<std::string>().find("mine.json"), std::string::npos);
}

TEST_F(KeptWindow, AFolderThatCannotBeWrittenStopsNothing) {
    std::ofstream(home / "flipside") << "a file where the folder would be";
    start({"drop"});
    const Json state = window->wait("a word of it", [](const Json& s) { return s["notice"] != ""; });
    EXPECT_NE(state["notice"].get<std::string>().find("nothing is kept"), std::string::npos);
    end();
    fs::remove(home / "flipside");
}

TEST_F(KeptWindow, WithoutSettingsNothingIsReadOrWritten) {
    open("drop");
    const fs::path nowhere = window->folder() / "flipside";
    click("Boxes");
    end();
    EXPECT_FALSE(fs::exists(nowhere));
}

TEST(Kept, IsInTheStateFolderOfTheUser) {
    const auto with = [](const char* state, const char* home) {
        state == nullptr ? unsetenv("XDG_STATE_HOME") : setenv("XDG_STATE_HOME", state, 1);
        home == nullptr ? unsetenv("HOME") : setenv("HOME", home, 1);
        return kept_file();
    };
    const std::string before = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
    EXPECT_EQ(with("/a/state", "/home/u"), fs::path("/a/state/flipside/window.json"));
    EXPECT_EQ(with(nullptr, "/home/u"), fs::path("/home/u/.local/state/flipside/window.json"));
    EXPECT_EQ(with("relative", "/home/u"), fs::path("/home/u/.local/state/flipside/window.json"));
    EXPECT_EQ(with("", nullptr), std::nullopt);
    with(nullptr, before.c_str());
}

TEST(Kept, ComesBackAsItWas) {
    std::string name = (fs::temp_directory_path() / "flipside-kept-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    const fs::path file = fs::path(name) / "deep" / "window.json";
    Kept kept;
    kept.width = 1921;
    kept.scale = 1.25;
    kept.scene = "/somewhere/\"odd\" näme.json";
    kept.lesson = "14-rest";
    kept.view = View::overlay;
    kept.contenders = {"a=custom,dt=0.016666666666666666,solver=simple", "b=reference"};
    kept.look.shows.set(3);
    kept.look.random_colours = true;
    kept.look.artwork = false;
    kept.panel_open = false;
    kept.plots = PlotChoice::tests;
    kept.strip = 201.5;
    Keeper keeper(file);
    EXPECT_TRUE(keeper.first_start());
    EXPECT_EQ(keeper.keep(kept), "");
    EXPECT_EQ(load_kept(file), kept);
    EXPECT_EQ(*Keeper(file).found(), kept);
    fs::remove_all(name);
}

}  // namespace
}  // namespace flipside::app
