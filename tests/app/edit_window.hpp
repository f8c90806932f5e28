#pragma once
/// Drawing scenes in the real window by real clicks, drags and keys, with files in a folder of their own.

#include <filesystem>

#include "app/window_fixture.hpp"
#include "lab/files/assets.hpp"
#include "places.hpp"
#include "world/json_file.hpp"

namespace flipside::app {

namespace fs = std::filesystem;

class EditWindow : public WindowTest {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-drawn-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override {
        WindowTest::TearDown();
        fs::remove_all(folder);
    }
    /// A copy of a shipped scene, which may be written.
    std::string copy_of(const std::string& scene) const {
        const fs::path copy = folder / (scene + ".json");
        fs::copy_file(lab::scene_file(scene), copy);
        return copy.string();
    }
    Json edit(const std::string& what, const RealWindow::Condition& condition) {
        return window->wait(what,
                            [&](const Json& s) { return !s["edit"].is_null() && condition(s["edit"]); });
    }
    Json begin_edit() {
        window->key("F4");
        return edit("the edit mode", [](const Json&) { return true; });
    }
    /// A place of the table on the screen, as it is drawn now.
    static std::string pixel(const Json& state, double x, double y) {
        const Json &pane = state["layout"]["panes"][0], &center = state["center"];
        const double scale = state["scale"];
        const double px =
            pane[0].get<double>() + 0.5 * pane[2].get<double>() + scale * (x - center[0].get<double>());
        const double py =
            pane[1].get<double>() + 0.5 * pane[3].get<double>() - scale * (y - center[1].get<double>());
        return std::to_string(std::lround(px)) + ' ' + std::to_string(std::lround(py));
    }
    static std::string pixel(const Json& at) {
        return std::to_string(std::lround(at[0].get<double>())) + ' ' +
               std::to_string(std::lround(at[1].get<double>()));
    }
    void drag(const std::string& from, const std::string& to) const {
        window->xdotool("mousemove " + from + " mousedown 1 mousemove " + to + " mouseup 1");
    }
    /// Presses the key of a tool, and drags from one place to the other.
    Json draw(const std::string& letter, double ax, double ay, double bx, double by) {
        window->key(letter);
        const Json state = settled();
        const std::size_t before = state["edit"]["parts"];
        drag(pixel(state, ax, ay), pixel(state, bx, by));
        return edit("one part more", [&](const Json& e) { return e["parts"] == before + 1; });
    }
    void type_into(const std::string& field, const std::string& text) {
        window->click(scroll_to_field(field));
        // A click picks all that is there; what is typed takes its place.
        window->wait("the field", [&](const Json& s) { return s["focus"] == field; });
        window->now();
        window->xdotool("type --delay 20 '" + text + "'");
        window->key("Return");
    }
    Json scroll_to_field(const std::string& field) {
        for (int i = 0; i < 8; ++i) {
            const Json state = settled();
            if (state["controls"].contains(field)) return state["controls"][field];
            const Json panel = state["layout"]["panel"];
            window->xdotool("mousemove " + std::to_string(panel[0].get<int>() + 4) + ' ' +
                            std::to_string(panel[3].get<int>() / 2) + " click 5 click 5");
        }
        throw std::runtime_error(field + " is not to be seen");
    }
    /// The exit code of another run of the program.
    static int run_program(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), test::flipside_program);
        return Process(arguments).wait(60);
    }
    void save_as(const fs::path& file) {
        window->key("ctrl+shift+s");
        window->wait("the question for a name",
                     [](const Json& s) { return s["controls"].contains("Save here"); });
        type_name(file);
    }
    /// Into the field that has the keyboard, in place of what is proposed there.
    void type_name(const fs::path& file) {
        window->wait("the field", [](const Json& s) { return s["focus"] == "File"; });
        window->now();
        window->xdotool("type --delay 20 '" + file.string() + "'");
        window->key("Return");
    }

    fs::path folder;
};

}  // namespace flipside::app
