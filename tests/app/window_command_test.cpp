/// What play and render say before they ask for a display.

#include "command_line.hpp"

namespace flipside::app {
namespace {

class WindowCommand : public CommandLine {
  protected:
    [[nodiscard]] std::string first_line(const std::string& arguments) const {
        const std::string words = flipside(arguments).err;
        return words.substr(0, words.find('\n') + 1);
    }
};

TEST_F(WindowCommand, TellsSettingsWithoutEffect) {
    const std::string note = ": motion_iterations has no effect here, only with solver simple\n";
    const std::string set = " --set motion_iterations=8";
    const std::string render = "render drop --engine custom --out " + file("x.png");
    EXPECT_EQ(first_line(render + set), "flipside: custom" + note);
    EXPECT_NE(first_line(render + set + " --set solver=simple"), "flipside: custom" + note);
    EXPECT_EQ(first_line("play drop --set custom.motion_iterations=8"), "flipside: custom" + note);
    EXPECT_EQ(first_line("play drop --contender a=custom,motion_iterations=8"), "flipside: a" + note);
}

TEST_F(WindowCommand, ChecksWhatIsToBeShown) {
    std::ofstream(file("bad.json")) << "{}";
    expect_refused("play " + file("bad.json"), 2, "bad.json: ");
    expect_refused("play toy --script " + file("bad.json"), 2, "bad.json: ");
    expect_refused("play --lesson " + file("bad.json"), 2, "bad.json: ");
    expect_refused("render drop --engine custom --show nosuch --out " + file("x.png"), 2, "nosuch");
    expect_refused("render drop --engine custom --script " + file("bad.json") + " --out " + file("x.png"), 2,
                   "bad.json: ");
    expect_refused("play toy --set custom.foo=1", 2, "foo");
    expect_refused("play toy --contender a=custom,foo=1", 2, "foo");
}

}  // namespace
}  // namespace flipside::app
