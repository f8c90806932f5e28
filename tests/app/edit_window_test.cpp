/// Drawing scenes in the real window.

#include "app/edit_window.hpp"

namespace flipside::app {
namespace {

TEST_F(EditWindow, ASceneIsDrawnFromNothingAndRunsOnAllEngines) {
    open();
    begin_edit();
    click("New");
    edit("an empty table", [](const Json& e) { return e["name"] == "" && e["parts"] == 0; });
    // A box whose last corner is its first one.
    window->key("l");
    const Json empty = settled();
    for (const auto& [x, y] : {std::pair{0.02, 0.9}, {0.02, 0.1}, {0.5, 0.1}, {0.5, 0.9}, {0.022, 0.898}})
        window->xdotool("mousemove " + pixel(empty, x, y) + " click 1");
    const Json box = edit("a box", [](const Json& e) { return e["parts"] == 1; });
    EXPECT_EQ(box["edit"]["thing"]["shape"]["points"],
              Json::parse("[[0.02,0.9],[0.02,0.1],[0.5,0.1],[0.5,0.9]]"));
    EXPECT_EQ(box["edit"]["thing"]["shape"]["closed"], true);
    // A wall that joins a corner, an arc, a bumper and a flipper.
    const Json wall = draw("w", 0.3, 0.2, 0.498, 0.103);
    EXPECT_EQ(wall["edit"]["thing"]["shape"]["b"], Json::parse("[0.5,0.1]"));
    draw("a", 0.5, 0.7, 0.4, 0.8);
    draw("c", 0.25, 0.6, 0.28, 0.6);
    const Json flipper = draw("f", 0.1, 0.3, 0.17, 0.28);
    EXPECT_EQ(flipper["edit"]["thing"]["motion"]["side"], "left");
    window->key("b");
    window->xdotool("mousemove " + pixel(settled(), 0.24, 0.8) + " click 1");
    edit("a ball", [](const Json& e) { return e["balls"] == 1; });
    EXPECT_TRUE(settled()["edit"]["problem"].is_null());

    const fs::path file = folder / "drawn.json";
    save_as(file);
    edit("the file", [&](const Json& e) { return e["unsaved"] == false && e["name"] == file.string(); });
    EXPECT_EQ(run_program({"check", file.string()}), 0);
    for (const char* engine : {"custom", "box2d", "reference"})
        EXPECT_EQ(run_program({"run", file.string(), "--engine", engine, "--seconds", "0.5", "--stats",
                               (folder / "stats.json").string()}),
                  0)
            << engine;
    window->key("F4");
    const Json played = window->wait("a fall on both", [](const Json& s) {
        return s["edit"].is_null() && s["time"] > 0.3 && s["panes"][1]["balls"].size() == 1;
    });
    EXPECT_EQ(played["scene"], file.string());
    EXPECT_LT(played["panes"][0]["balls"][0]["velocity"][1], 0);
    EXPECT_EQ(played["panes"][0]["flippers"].size(), 1U);
}

/// Three walls and a ball: what Shift picks is moved, copied and deleted together, and undone as one.
TEST_F(EditWindow, SeveralThingsArePickedMovedCopiedAndDeletedTogether) {
    open();
    begin_edit();
    click("New");
    edit("an empty table", [](const Json& e) { return e["name"] == "" && e["parts"] == 0; });
    draw("w", 0.1, 0.3, 0.2, 0.3);
    draw("w", 0.1, 0.5, 0.2, 0.5);
    draw("w", 0.1, 0.7, 0.2, 0.7);
    window->key("b");
    window->xdotool("mousemove " + pixel(settled(), 0.4, 0.8) + " click 1");
    edit("a ball", [](const Json& e) { return e["balls"] == 1; });
    window->key("s");
    const Json all = settled();
    const auto click_at = [&](double x, double y, const char* held = nullptr) {
        const std::string shift = held ? std::string("keydown ") + held + " sleep 0.1 " : "";
        window->xdotool(shift + "mousemove " + pixel(all, x, y) + " click 1" +
                        (held ? std::string(" sleep 0.1 keyup ") + held : ""));
    };
    const auto picked = [&](int count) {
        return edit(std::to_string(count) + " picked",
                    [&](const Json& e) { return e["selection"] == count; });
    };
    click_at(0.15, 0.3);
    picked(1);
    click_at(0.15, 0.5, "shift");
    picked(2);
    click_at(0.4, 0.8, "shift");
    const Json three = picked(3);
    EXPECT_TRUE(three["edit"]["handles"].empty());
    EXPECT_TRUE(settled()["controls"].contains("several things"));
    click_at(0.15, 0.5, "shift");
    picked(2);
    click_at(0.15, 0.5, "shift");
    picked(3);
    // Dragged by one of them, all move; the wall that was not picked stays.
    drag(pixel(all, 0.15, 0.3), pixel(all, 0.25, 0.34));
    edit("a move", [](const Json& e) {
        return e["selection"] == 3 && e["thing"]["shape"]["a"] != Json::parse("[0.1,0.3]");
    });
    window->key("ctrl+d");
    edit("copies", [](const Json& e) { return e["parts"] == 5 && e["balls"] == 2 && e["selection"] == 3; });
    window->key("Delete");
    edit("the first ones alone",
         [](const Json& e) { return e["parts"] == 3 && e["balls"] == 1 && e["selection"] == 0; });

    const fs::path file = folder / "moved.json";
    save_as(file);
    edit("the file", [&](const Json& e) { return e["unsaved"] == false; });
    const Json scene = Json::parse(read_file(file));
    EXPECT_EQ(scene["parts"][0]["shape"]["a"], Json::parse("[0.2,0.34]"));
    EXPECT_EQ(scene["parts"][1]["shape"]["a"], Json::parse("[0.2,0.54]"));
    EXPECT_EQ(scene["parts"][2]["shape"]["a"], Json::parse("[0.1,0.7]"));
    EXPECT_EQ(scene["balls"][0]["position"], Json::parse("[0.5,0.84]"));
    for (int i = 0; i < 3; ++i) window->key("ctrl+z");  // each of them took one step
    edit("as it was drawn", [](const Json& e) { return e["parts"] == 3 && e["balls"] == 1; });
    window->key("ctrl+a");
    picked(4);
    window->key("Delete");
    edit("nothing", [](const Json& e) { return e["parts"] == 0 && e["balls"] == 0; });
    window->key("ctrl+z");
    edit("all of it", [](const Json& e) { return e["parts"] == 3 && e["balls"] == 1; });
}

TEST_F(EditWindow, GeneratedBallsAreSaidNotToBeEditable) {
    open("rain");
    begin_edit();
    const Json state = settled();
    EXPECT_TRUE(state["controls"].contains("generated"));
    EXPECT_EQ(state["edit"]["balls"], 0);
}

TEST_F(EditWindow, WhatIsWrongIsSaidAndUndone) {
    open("drop");
    const Json state = begin_edit();
    // Beyond the bounds, and still in the pane.
    const Json& pane = state["layout"]["panes"][0];
    const std::string outside = pixel(Json{pane[0].get<double>() + 5, pane[1].get<double>() + 5});
    window->key("Tab");
    window->key("Tab");
    const Json picked = edit("the ball", [](const Json& e) { return e["selected"][0] == "balls"; });
    drag(pixel(picked["edit"]["handles"]["centre 0"]), outside);
    edit("the fault", [](const Json& e) {
        return !e["problem"].is_null() &&
               e["problem"].get<std::string>().starts_with("a ball lies outside the bounds");
    });
    window->key("F4");
    const Json refused = window->wait("a notice", [](const Json& s) { return s["notice"] != ""; });
    EXPECT_FALSE(refused["edit"].is_null());
    window->click(refused["controls"]["I see"]);
    window->wait("no notice", [](const Json& s) { return s["notice"] == ""; });
    window->key("ctrl+s");
    window->wait("a refusal",
                 [](const Json& s) { return s["notice"].get<std::string>().starts_with("Not saved"); });
    window->key("ctrl+z");
    edit("no fault", [](const Json& e) { return e["problem"].is_null() && e["unsaved"] == false; });
    window->key("ctrl+shift+z");
    edit("the fault again", [](const Json& e) { return !e["problem"].is_null(); });
    window->key("ctrl+z");
    window->key("Delete");
    edit("no ball", [](const Json& e) { return e["balls"] == 0; });
    window->key("F4");
    window->wait("an empty table", [](const Json& s) {
        return s["edit"].is_null() && s["panes"][0]["balls"].empty() && s["panes"][1]["balls"].empty();
    });
}

TEST_F(EditWindow, NumbersAreTypedExactly) {
    open(copy_of("toy"));
    const Json state = begin_edit();
    window->xdotool("mousemove " + pixel(state, 0.5, 0.032) + " click 1");
    edit("the floor", [](const Json& e) { return e["thing"].value("name", "") == "floor"; });
    type_into("From x", "33.25");
    edit("the number", [](const Json& e) { return e["thing"]["shape"]["a"] == Json{0.03325, 0.032}; });
    type_into("Name", "bottom");
    edit("the name", [](const Json& e) { return e["thing"]["name"] == "bottom"; });
    window->key("ctrl+z");
    window->key("ctrl+z");
    edit("all as before", [](const Json& e) { return e["unsaved"] == false; });
}

/// Of what is picked; "" of what is no part.
std::string shape_of(const Json& edited) {
    return edited["thing"].value("/shape/type"_json_pointer, "");
}

/// Whether two rectangles meet along an axis: 0 for x, 1 for y.
bool meet(const Json& a, const Json& b, std::size_t axis) {
    constexpr double touch = 0.5;
    return a[axis].get<double>() + touch < b[axis].get<double>() + b[axis + 2].get<double>() &&
           b[axis].get<double>() + touch < a[axis].get<double>() + a[axis + 2].get<double>();
}

/// Controls lie in the window, side by side.
void expect_apart(const Json& state) {
    const Json& window = state["layout"]["window"];
    for (const auto& [name, a] : state["controls"].items()) {
        EXPECT_GE(a[0], 0) << name;
        EXPECT_LE(a[0].get<double>() + a[2].get<double>(), window[0].get<double>() + 0.5) << name;
        for (const auto& [other, b] : state["controls"].items()) {
            EXPECT_FALSE(name < other && meet(a, b, 0) && meet(a, b, 1)) << name << " and " << other;
        }
    }
}

TEST_F(EditWindow, NothingIsCutOffOrLiesOverAnotherInASmallWindow) {
    open("pinball", "split", "custom", {"--width", "1024", "--height", "640"});
    begin_edit();
    const Json table = settled();
    expect_apart(table);
    for (const std::string_view kind : {"gate", "circle", "polygon", "flipper"}) {
        for (Json edited = settled()["edit"]; shape_of(edited) != kind;) {
            window->key("Tab");
            edited = edit("the next thing",
                          [&](const Json& e) { return e["selected"] != edited["selected"]; })["edit"];
        }
        const Json picked = settled();
        expect_apart(picked);
        for (const auto& [name, at] : picked["edit"]["handles"].items()) {
            const Json& pane = picked["layout"]["panes"][0];
            for (const std::size_t k : {0U, 1U}) {
                EXPECT_GT(at[k].get<double>(), pane[k].get<double>()) << name;
                EXPECT_LT(at[k].get<double>(), pane[k].get<double>() + pane[k + 2].get<double>()) << name;
            }
        }
    }
    window->key("F3");
    window->wait("the scenes", [](const Json& s) { return s["browser"] == true; });
    Json cards = Json::object();
    const Json browser = settled();
    for (const auto& [name, rect] : browser["controls"].items())
        if (name.starts_with("scene card") || name == "Back") cards[name] = rect;
    EXPECT_GE(cards.size(), 4U) << "a row, and the way back";
    expect_apart({{"layout", table["layout"]}, {"controls", cards}});
}

TEST_F(EditWindow, TheBrowserOpensASceneByKeysAndByAClick) {
    open("bowl");
    window->key("F3");
    const Json cards = window->wait("the scenes", [](const Json& s) {
        return s["browser"] == true && s["controls"].contains("scene card toy");
    });
    const double time = cards["time"];
    window->key("Right");
    window->key("Return");
    const Json box =
        window->wait("box", [](const Json& s) { return s["browser"] == false && s["scene"] == "box"; });
    EXPECT_LT(box["time"], time + 1);
    window->key("F3");
    window->wait("the scenes", [](const Json& s) { return s["controls"].contains("scene card toy"); });
    window->click(settled()["controls"]["scene card toy"]);
    window->wait("toy", [](const Json& s) { return s["browser"] == false && s["scene"] == "toy"; });
    window->key("F3");
    window->wait("the scenes", [](const Json& s) { return s["browser"] == true; });
    window->key("Escape");
    window->wait("toy again", [](const Json& s) { return s["browser"] == false && s["scene"] == "toy"; });
}

}  // namespace
}  // namespace flipside::app
