/// Where everything is in windows from small to very large: inside, and not over one another.

#include <algorithm>

#include "app/window/layout.hpp"
#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

struct Size {
    int width, height;
    double scale;  ///< that suits it on a display of 2160 lines
};

class WindowSizes : public testing::TestWithParam<Size> {
  protected:
    static void SetUpTestSuite() { display = std::make_unique<VirtualDisplay>("3840x2160"); }
    static void TearDownTestSuite() { display.reset(); }

    void open(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--width", std::to_string(GetParam().width), "--height",
                                           std::to_string(GetParam().height)});
        window = std::make_unique<RealWindow>(arguments);
    }
    void TearDown() override {
        if (!window) return;
        const auto folder = window->folder();
        window.reset();
        std::filesystem::remove_all(folder);
    }
    Json settled() { return window->settled(); }

    static inline std::unique_ptr<VirtualDisplay> display;
    std::unique_ptr<RealWindow> window;
};

Rect rect_of(const Json& j) {
    return {j[0], j[1], j[2], j[3]};
}

bool meet(const Rect& a, const Rect& b) {
    constexpr double touch = 0.5;  // controls have fractions of pixels
    return a.x + touch < b.x + b.width && b.x + touch < a.x + a.width && a.y + touch < b.y + b.height &&
           b.y + touch < a.y + a.height;
}

bool lies_in(const Rect& a, const Rect& b) {
    return a.x >= b.x - 0.5 && a.y >= b.y - 0.5 && a.x + a.width <= b.x + b.width + 0.5 &&
           a.y + a.height <= b.y + b.height + 0.5;
}

void expect_apart(const std::vector<std::pair<std::string, Rect>>& rects, const Rect& within) {
    for (std::size_t i = 0; i < rects.size(); ++i) {
        EXPECT_TRUE(lies_in(rects[i].second, within)) << rects[i].first << " is cut off";
        for (std::size_t j = i + 1; j < rects.size(); ++j)
            EXPECT_FALSE(meet(rects[i].second, rects[j].second))
                << rects[i].first << " and " << rects[j].first << " lie over one another";
    }
}

void expect_in_order(const Json& state) {
    const Json& layout = state["layout"];
    std::vector<std::pair<std::string, Rect>> rects;
    for (const char* name : {"strip", "panel"}) rects.emplace_back(name, rect_of(layout[name]));
    if (layout["bar"][3] > 0) rects.emplace_back("bar", rect_of(layout["bar"]));
    for (const char* names : {"panes", "headers"})
        for (const Json& rect : layout[names]) rects.emplace_back(names, rect_of(rect));
    expect_apart(rects, {0, 0, layout["window"][0], layout["window"][1]});

    // A step in a header is there as a whole or not at all.
    for (const auto& [name, rect] : state["controls"].items())
        if (name.ends_with(": Step in the header")) {
            const Rect step = rect_of(rect);
            const auto around = std::ranges::count_if(
                layout["headers"], [&](const Json& header) { return lies_in(step, rect_of(header)); });
            EXPECT_EQ(around, 1) << name;
        }

    rects.clear();
    const Rect panel = rect_of(layout["panel"]);
    for (const auto& [name, rect] : state["controls"].items()) {
        const Rect control = rect_of(rect);
        // One that is scrolled half out of sight is no fault.
        if (control.x >= panel.x && control.y + control.height <= panel.height)
            rects.emplace_back(name, control);
    }
    EXPECT_GT(rects.size(), 6U);
    expect_apart(rects, panel);
}

TEST_P(WindowSizes, OpensInTheMiddleOfTheDisplay) {
    open({"drop"});
    EXPECT_EQ(window->first_place(), std::to_string((3840 - GetParam().width) / 2) + "," +
                                         std::to_string((2160 - GetParam().height) / 2));
}

TEST_P(WindowSizes, NothingIsCutOffOrLiesOverAnother) {
    open({"pinball"});
    for (const char* tab : {"Lesson", "Table", "See", "Engines", "Numbers"}) {
        SCOPED_TRACE(tab);
        window->click(settled()["controls"][tab]);
        expect_in_order(settled());
    }
    window->key("i");
    window->wait("the step bar", [](const Json& s) { return s["step_bar"] == true; });
    window->key("period");
    expect_in_order(window->wait("a stage", [](const Json& s) { return s.contains("inside"); }));
}

TEST_P(WindowSizes, FourContendersHaveRoomInEveryView) {
    open({"pinball", "--contender", "toy-at-one-flight=custom,solver=simple,motion_iterations=1",
          "--contender", "custom=custom", "--contender", "box2d=box2d", "--contender",
          "fine=box2d,dt=1/240"});
    for (const char* key : {"2", "3", "1"}) {
        window->key(key);
        const Json state = window->wait("the view", [&](const Json& s) {
            return s["view"] == (*key == '1' ? "single" : *key == '2' ? "split" : "overlay");
        });
        expect_in_order(settled());
        for (const Json& pane : state["layout"]["panes"]) {
            EXPECT_GT(pane[2], 120 * GetParam().scale);
            EXPECT_GT(pane[3], 90 * GetParam().scale);
        }
    }
    window->key("2");
    window->key("i");
    window->key("period");
    window->wait("a stage", [](const Json& s) { return s.contains("inside") && s["view"] == "split"; });
    for (const char* tab : {"Lesson", "Table", "See", "Engines", "Numbers"}) {
        SCOPED_TRACE(tab);
        window->click(settled()["controls"][tab]);
        expect_in_order(settled());
    }
}

TEST_P(WindowSizes, LettersSuitTheWindowUntilTheUserSaysOtherwise) {
    open({"drop"});
    const auto height_of_a_control = [&] { return settled()["controls"]["Scene"][3].get<double>(); };
    EXPECT_NEAR(height_of_a_control() / GetParam().scale, 22.4, 1.5);
    const double before = height_of_a_control();
    window->key("ctrl+minus");
    window->wait("smaller letters",
                 [&](const Json& s) { return s["letters"] == std::max(0.75, GetParam().scale - 0.25); });
    EXPECT_EQ(height_of_a_control() < before, GetParam().scale > 0.75);
    expect_in_order(settled());
    window->key("ctrl+0");
    window->wait("the usual size", [](const Json& s) { return s["letters"] == 0; });
    EXPECT_EQ(height_of_a_control(), before);
}

TEST_P(WindowSizes, LettersThatAreTooLargeForTheWindowGetAsLargeAsItHasRoomFor) {
    open({"pinball", "--scale", "3"});
    for (const char* tab : {"Lesson", "Table", "See"}) {
        SCOPED_TRACE(tab);
        window->click(settled()["controls"][tab]);
        const Json state = settled();
        expect_in_order(state);
        EXPECT_GT(state["layout"]["panel"][0], 0.45 * GetParam().width);
    }
    window->key("ctrl+minus");
    window->wait("smaller letters", [&](const Json& s) { return s["letters"] < 3; });
}

INSTANTIATE_TEST_SUITE_P(FromSmallToLarge, WindowSizes,
                         testing::Values(Size{800, 600, 0.75}, Size{1024, 640, 1}, Size{1280, 800, 1.25},
                                         Size{2560, 1440, 2}, Size{3840, 2160, 2}),
                         [](const auto& chosen) {
                             return std::to_string(chosen.param.width) + "x" +
                                    std::to_string(chosen.param.height);
                         });

}  // namespace
}  // namespace flipside::app
