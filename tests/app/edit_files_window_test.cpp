/// Files of scenes that are drawn: saved, not written over, not lost.

#include <fstream>

#include "app/edit_window.hpp"

namespace flipside::app {
namespace {

TEST_F(EditWindow, AnEndThatIsDraggedIsSavedAndNoOtherLetterChanges) {
    const std::string file = copy_of("toy");
    const std::string before = read_file(file);
    open(file);
    const Json state = begin_edit();
    window->xdotool("mousemove " + pixel(state, 0.5, 0.032) + " click 1");
    const Json picked =
        edit("the floor", [](const Json& e) { return e["thing"].value("name", "") == "floor"; });
    drag(pixel(picked["edit"]["handles"]["corner 1"]), pixel(picked, 0.9, 0.1));
    const Json moved = edit("its other end", [](const Json& e) {
        return e["thing"]["shape"]["b"] == Json{0.9, 0.1};
    });
    EXPECT_EQ(moved["edit"]["unsaved"], true);
    window->key("ctrl+s");
    edit("the file", [](const Json& e) { return e["unsaved"] == false; });
    std::string wanted = before;
    const std::string end = R"("b": [0.992, 0.032])";
    wanted.replace(wanted.find(end), end.size(), R"("b": [0.9, 0.1])");
    EXPECT_EQ(read_file(file), wanted);

    window->key("F4");
    const Json played = window->wait("the table", [](const Json& s) { return s["edit"].is_null(); });
    EXPECT_EQ(played["panes"].size(), 2U);
    EXPECT_LT(played["time"], 1);
}

TEST_F(EditWindow, NoFileIsWrittenOverThatIsNotItsOwn) {
    const std::string shipped = read_file(lab::scene_file("drop"));
    std::ofstream(folder / "other.json") << "somebody's";
    open("drop");
    begin_edit();
    window->key("ctrl+d");
    window->key("Tab");
    window->key("ctrl+d");
    edit("a change", [](const Json& e) { return e["unsaved"] == true; });
    window->key("ctrl+s");
    window->wait("the question for a name",
                 [](const Json& s) { return s["controls"].contains("Save here"); });
    EXPECT_EQ(read_file(lab::scene_file("drop")), shipped);
    type_name(folder / "other.json");
    const Json asked =
        window->wait("a question", [](const Json& s) { return s["controls"].contains("Replace it"); });
    EXPECT_EQ(asked["edit"]["unsaved"], true);
    EXPECT_EQ(read_file(folder / "other.json"), "somebody's");
    click("Replace it");
    edit("the file", [](const Json& e) { return e["unsaved"] == false; });
    EXPECT_EQ(run_program({"check", (folder / "other.json").string()}), 0);
    // What somebody else writes there then is not lost either.
    std::ofstream(folder / "other.json") << shipped;
    window->key("ctrl+d");
    window->key("ctrl+s");
    window->wait("a question", [](const Json& s) { return s["controls"].contains("Replace it"); });
    EXPECT_EQ(read_file(folder / "other.json"), shipped);
}

TEST_F(EditWindow, UnsavedDrawingsAreNotLostAtOnce) {
    open(copy_of("drop"));
    begin_edit();
    window->key("Tab");
    window->key("Up");
    edit("a change", [](const Json& e) { return e["unsaved"] == true; });
    window->key("F4");
    window->wait("the table", [](const Json& s) { return s["edit"].is_null(); });
    window->key("Escape");
    window->wait("a warning", [](const Json& s) {
        return s["notice"].get<std::string>().find("not saved") != std::string::npos;
    });
    EXPECT_TRUE(window->program().running());
    window->key("F4");
    window->wait("the table", [](const Json& s) { return s["edit"].is_null(); });
    window->key("F4");
    edit("what was drawn", [](const Json& e) { return e["unsaved"] == true; });
    window->key("ctrl+z");
    edit("the file as it is", [](const Json& e) { return e["unsaved"] == false; });
    window->wait("no warning any more", [](const Json& s) {
        return s["notice"].get<std::string>().find("not saved") == std::string::npos;
    });
}

}  // namespace
}  // namespace flipside::app
