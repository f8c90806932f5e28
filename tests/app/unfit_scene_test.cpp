/// A scene that one engine alone cannot run, by all commands.

#include "command_line.hpp"

namespace flipside::app {
namespace {

class UnfitScene : public CommandLine {
  protected:
    std::string heavy = file("heavy.json"), light = file("light.json");

    [[nodiscard]] static std::string scene(const std::string& mass) {
        return R"({"format": "flipside-scene/1", "name": "bounce", "gravity": [0, -9.81],
            "bounds": {"min": [-1, -1], "max": [1, 2]},
            "balls": [{"position": [0, 1], "radius": 0.1, "mass": )" +
               mass + R"(}],
            "parts": [{"name": "floor", "shape": {"type": "segment", "a": [-1, 0], "b": [1, 0]}}]})";
    }
    void SetUp() override {
        CommandLine::SetUp();
        std::ofstream(heavy) << scene("1e29");
        std::ofstream(light) << scene("1");
    }
};

TEST_F(UnfitScene, IsRefusedWithFileAndPointerByTheEngineAlone) {
    const std::string says = "heavy.json: /balls/0/mass: is 1e+29 kg; box2d computes in single precision";
    expect_refused("run " + heavy + " --engine box2d --out " + file("t.csv"), 2, says);
    EXPECT_FALSE(fs::exists(file("t.csv")));
    expect_good("run " + heavy + " --engine custom --seconds 0.5 --save " + file("s.json"));
    expect_refused("run " + light + " --engine box2d --from " + file("s.json"), 2,
                   "s.json: /balls/0/mass: is 1e+29 kg; box2d computes in single precision");
}

TEST_F(UnfitScene, IsAGoodSceneWithANote) {
    const Result result = flipside("check " + heavy);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("heavy.json: good: scene 'bounce', parts 1, balls 1\n"), std::string::npos);
    EXPECT_NE(result.out.find("\nnote: box2d cannot run it: " + heavy + ": /balls/0/mass: is 1e+29 kg"),
              std::string::npos)
        << result.out;
}

TEST_F(UnfitScene, IsComparedOnTheOthers) {
    const Result result = flipside("compare " + heavy +
                                   " --engines custom,box2d,reference --seconds 1 --json " + file("c.json"));
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.out.find("box2d ended at 0 s: " + heavy + ": /balls/0/mass: is 1e+29 kg"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("custom and reference: 1 contacts"), std::string::npos) << result.out;
    EXPECT_TRUE(fs::exists(file("c.json")));
}

TEST_F(UnfitScene, IsSweptOnTheOthers) {
    const Result result = flipside("sweep " + heavy + " --quick --finest 60 --contenders " +
                                   "custom-continuous,box2d --out " + file("sweep"));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("/balls/0/mass: is 1e+29 kg"), std::string::npos) << result.err;
    EXPECT_TRUE(fs::exists(file("sweep/sweep.csv")));
}

}  // namespace
}  // namespace flipside::app
