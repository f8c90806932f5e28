/// `flipside replay` as a shell runs it.

#include <nlohmann/json.hpp>

#include "app/command_line.hpp"

namespace flipside::app {
namespace {

class ReplayCommand : public CommandLine {
  protected:
    void SetUp() override {
        CommandLine::SetUp();
        std::ofstream(file("script.json")) << R"({"format": "flipside-script/1", "controls": [
            {"time": 0.1, "control": "launch", "strength": 0.9},
            {"time": 1.505, "control": "flip", "side": "left", "up": true}]})";
    }
    void record(const std::string& engine) const {
        expect_good("run pinball --engine " + engine + " --seconds 30 --script " + file("script.json") +
                    " --replay " + game);
    }
    std::string game = file("-game.flipside-replay");
};

TEST_F(ReplayCommand, SaysThatARunIsTheSameToTheBit) {
    for (const std::string engine : {"custom", "box2d"}) {
        record(engine);
        const Result result = flipside("replay " + game);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_NE(result.out.find(engine + ": steps 1800, 30 s, score "), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("the same to the bit"), std::string::npos) << result.out;
    }
}

TEST_F(ReplayCommand, PlaysOnAnotherEngine) {
    record("custom");
    const Result result = flipside("replay " + game + " --engine box2d");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("box2d as played on custom: steps 1800, 30 s"), std::string::npos)
        << result.out;
    expect_refused("replay " + game + " --engine cheese", 2, "cheese");
}

TEST_F(ReplayCommand, SaysWhereItPartedAndRefusesWhatIsDamaged) {
    record("custom");
    nlohmann::json replay = nlohmann::json::parse(text_of(game));
    replay["runs"][0]["script"]["controls"][1]["time"] = 12.3;
    std::ofstream(file("parted")) << replay;
    const Result parted = flipside("replay " + file("parted"));
    EXPECT_EQ(parted.code, 1);
    EXPECT_NE(parted.out.find("from between 0 s and 10 s on"), std::string::npos) << parted.out;
    EXPECT_NE(parted.err.find("is not the game that was saved"), std::string::npos) << parted.err;
    std::ofstream(file("half")) << text_of(game).substr(0, 3000);
    expect_refused("replay " + file("half"), 2, "not JSON");
    replay["runs"][0]["engine"] = "/tmp/x.so";
    std::ofstream(file("library")) << replay;
    expect_refused("replay " + file("library"), 2, "/runs/0/engine");
    expect_refused("replay " + file("none"), 2, "there is no such file");
}

TEST_F(ReplayCommand, AGameFromAStateIsNotSaved) {
    expect_good("run pinball --engine custom --seconds 1 --save " + file("state"));
    expect_refused(
        "run pinball --engine custom --seconds 1 --from " + file("state") + " --script none --replay " + game,
        2, "--replay: the game of 'custom' cannot be saved: it goes on from a state that does not come from");
}

}  // namespace
}  // namespace flipside::app
