/// Looking at balls and parts and moving them by hand in the real window, by real clicks, drags and keys.

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class HandWindow : public WindowTest {
  protected:
    static std::string at(double x, double y) {
        return std::to_string(std::lround(x)) + ' ' + std::to_string(std::lround(y));
    }
    static std::string at(const Json& pixel) { return at(pixel[0], pixel[1]); }
    Json paused_drop() {
        open("drop");
        window->wait("a fall", [](const Json& s) { return s["time"] > 0.2 && s["time"] < 5; });
        return pause();
    }
    Json card(const std::string& title) {
        return window->wait("the card of " + title, [&](const Json& s) {
            return !s["card"].is_null() && s["card"]["title"] == title;
        });
    }
    /// The numbers of a cell "a, b".
    static std::pair<double, double> numbers(std::string cell) {
        for (std::size_t minus; (minus = cell.find("−")) != std::string::npos;)
            cell.replace(minus, std::string("−").size(), "-");
        return {std::stod(cell), std::stod(cell.substr(cell.find(',') + 1))};
    }
    static void expect_in_words(const Json& cell, const Json& vector, double unit, double rounding) {
        const auto [x, y] = numbers(cell);
        EXPECT_NEAR(x, unit * vector[0].get<double>(), rounding);
        EXPECT_NEAR(y, unit * vector[1].get<double>(), rounding);
    }
};

TEST_F(HandWindow, AClickOnABallTellsItsStateOnEveryEngine) {
    const Json before = paused_drop();
    window->xdotool("mousemove " + at(before["panes"][1]["balls"][0]["pixel"]) + " click 1");
    const Json state = card("ball 0");
    for (std::size_t i = 0; i < 2; ++i) {
        const Json &ball = state["panes"][i]["balls"][0], &rows = state["card"]["rows"];
        expect_in_words(rows["Position, mm"][i], ball["position"], 1000, 0.0501);
        expect_in_words(rows["Velocity, m/s"][i], ball["velocity"], 1, 0.000501);
    }
    click("Close card");
    window->wait("no card", [](const Json& s) { return s["card"].is_null(); });
}

TEST_F(HandWindow, APulledBallIsThrownAsShownOnEveryEngine) {
    paused_drop();
    window->key("Home");
    const Json first = window->wait("the start", [](const Json& s) { return s["time"] == 0; });
    const Json& pixel = first["panes"][0]["balls"][0]["pixel"];
    const double x = pixel[0], y = pixel[1];
    window->xdotool("mousemove " + at(x, y) + " mousedown 1 mousemove " + at(x + 30, y + 10) + " mousemove " +
                    at(x + 40, y + 20));
    const Json pulled = window->wait("the sling", [&](const Json& s) {
        return !s["sling"].is_null() &&
               std::abs(s["sling"][0].get<double>() * s["scale"].get<double>() + 400) < 30;
    });
    // 10 m/s for each metre, away from the hand.
    EXPECT_NEAR(pulled["sling"][1].get<double>() * pulled["scale"].get<double>(), 200, 15);
    window->xdotool("mouseup 1");
    const Json thrown = window->wait("the throw", [](const Json& s) { return s["sling"].is_null(); });
    for (const Json& pane : thrown["panes"])
        EXPECT_LT(distance(pane["balls"][0]["velocity"], pulled["sling"]), 1e-9);
    EXPECT_EQ(thrown["center"], first["center"]);
    EXPECT_TRUE(thrown["card"].is_null());
}

TEST_F(HandWindow, TimeStandsStillWhileABallIsPulled) {
    open("cradle");
    window->key("s");
    const Json slow = window->wait("slow motion", [](const Json& s) { return s["speed"] == 0.1; });
    // The middle ball hands blows on and hardly moves, however late the mouse comes.
    const Json& pixel = slow["panes"][0]["balls"][2]["pixel"];
    const double x = pixel[0], y = pixel[1];
    window->xdotool("mousemove " + at(x, y) + " mousedown 1 mousemove " + at(x + 30, y) + " mousemove " +
                    at(x + 40, y));
    const Json pulled = window->wait("the sling", [](const Json& s) { return !s["sling"].is_null(); });
    const long frame = pulled["frame"];
    const Json later = window->wait("more frames", [&](const Json& s) { return s["frame"] > frame + 10; });
    EXPECT_EQ(later["time"], pulled["time"]);
    window->key("Escape");
    const Json let_go = window->wait("no sling", [](const Json& s) { return s["sling"].is_null(); });
    EXPECT_NEAR(let_go["panes"][0]["balls"][2]["position"][0], -0.0255, 0.003);
    window->xdotool("mouseup 1");
    window->wait("time to go on", [&](const Json& s) { return s["time"] > pulled["time"]; });
}

TEST_F(HandWindow, AClickWithCtrlAddsABallOnEveryEngineButNotIntoAWall) {
    const Json before = paused_drop();
    const Json& ball = before["panes"][0]["balls"][0];
    const double x = ball["pixel"][0], scale = before["scale"];
    const double floor = ball["pixel"][1].get<double>() + scale * ball["position"][1].get<double>();
    window->xdotool("mousemove " + at(x + 0.4 * scale, floor - 0.2 * scale) +
                    " keydown ctrl click 1 keyup ctrl");
    const Json two = window->wait("two balls", [](const Json& s) {
        return s["panes"][0]["balls"].size() == 2 && s["panes"][1]["balls"].size() == 2;
    });
    for (const Json& pane : two["panes"]) {
        EXPECT_EQ(pane["balls"][1]["number"], 1);
        EXPECT_NEAR(pane["balls"][1]["position"][0], 0.4, 0.01);
        EXPECT_NEAR(pane["balls"][1]["position"][1], 0.2, 0.01);
    }
    window->xdotool("mousemove " + at(x - 0.4 * scale, floor) + " keydown ctrl click 1 keyup ctrl");
    const Json notice =
        window->wait("a notice", [](const Json& s) { return !s["notice"].get<std::string>().empty(); });
    EXPECT_EQ(notice["notice"], "There is no free place for a ball");
    EXPECT_EQ(notice["panes"][0]["balls"].size(), 2U);
}

TEST_F(HandWindow, DeleteRemovesThePickedBallAndGoingBackBringsItAgain) {
    const Json before = paused_drop();
    window->key("o");
    card("ball 0");
    window->key("Delete");
    window->wait("empty tables", [](const Json& s) {
        return s["panes"][0]["balls"].empty() && s["panes"][1]["balls"].empty();
    });
    EXPECT_EQ(card("ball 0")["card"]["about"], "gone");
    window->key("comma");
    const Json back = window->wait("the ball", [](const Json& s) {
        return !s["panes"][0]["balls"].empty() && !s["panes"][1]["balls"].empty();
    });
    EXPECT_EQ(back["in_past"], true);
}

TEST_F(HandWindow, AFoldedColumnStillTellsWhatWentWrong) {
    paused_drop();
    window->key("F2");
    window->wait("the folded column", [](const Json& s) { return s["panel"] == false; });
    window->key("Delete");
    window->wait("a notice", [](const Json& s) { return s["controls"].contains("I see"); });
    const Json state = settled();
    EXPECT_TRUE(state["notice"].get<std::string>().starts_with("Pick a ball first"));
    window->click(state["controls"]["I see"]);
    window->wait("it to be read", [](const Json& s) { return s["notice"] == ""; });
}

TEST_F(HandWindow, NoCardLiesOverTheHelp) {
    paused_drop();
    window->key("o");
    card("ball 0");
    window->key("F1");
    window->wait("the help", [](const Json& s) { return s["help"] == true; });
    EXPECT_FALSE(settled()["controls"].contains("Card"));
    window->key("F1");
    card("ball 0");
}

TEST_F(HandWindow, KeysPickAndEscapePutsAwayBeforeItCloses) {
    const Json before = paused_drop();
    window->key("l");
    // The ball meets the floor at 0.4515 s; a slow machine pauses later.
    EXPECT_EQ(card("floor")["card"]["rows"]["Last impact"][0] == "none", before["time"] < 0.4515);
    window->key("o");
    card("ball 0");
    window->key("k");
    window->key("Escape");
    card("Last impact");
    window->key("Escape");
    window->wait("no card", [](const Json& s) { return s["card"].is_null(); });
    window->key("Delete");
    window->wait("a notice", [](const Json& s) { return !s["notice"].get<std::string>().empty(); });
    EXPECT_TRUE(window->program().running());
    window->key("Escape");
    EXPECT_EQ(window->program().wait(60), 0);
}

TEST_F(HandWindow, TheImpactOfAKnownDropIsAsPredicted) {
    paused_drop();
    window->key("Home");
    window->wait("the start", [](const Json& s) { return s["time"] == 0; });
    window->key("k");
    window->key("e");
    window->wait("the card", [](const Json& s) { return !s["card"].is_null(); });
    window->key("s");
    window->key("p");
    window->wait("the first impact", [](const Json& s) { return s["time"] > 0.6; });
    const Json state = pause();
    ASSERT_LT(state["time"], 1.17) << "the second impact";
    const Json& rows = state["card"]["rows"];
    for (const std::size_t i : {0U, 2U}) {
        EXPECT_EQ(rows["Last impact"][i], "floor\n0.4515 s");
        EXPECT_EQ(rows["Speed before"][i], "4.429 m/s");
        EXPECT_EQ(rows["Restitution"][i], "0.800 of 0.800");
    }
    EXPECT_EQ(rows["Wrong by"][0], "on time\nnormal exact");
}

TEST_F(HandWindow, TheCardCoversNoBallThatItTellsOfAndStaysInTheWindow) {
    open("drop", "overlay");
    window->wait("the floor", [](const Json& s) { return s["time"] > 1; });
    window->key("o");
    for (const auto& size : {std::pair{800, 600}, std::pair{1280, 800}, std::pair{1900, 1000}}) {
        const int width = size.first, height = size.second;
        window->resize(width, height);
        window->wait("the new size", [&](const Json& s) {
            return s["layout"]["window"] == Json{width, height};
        });
        card("ball 0");
        const Json state = settled();
        const Json place = state["controls"]["Card"];
        const double left = place[0], top = place[1], right = left + place[2].get<double>(),
                     bottom = top + place[3].get<double>();
        EXPECT_GE(left, 0);
        EXPECT_LE(right, width);
        EXPECT_LE(bottom, height);
        for (const Json& pane : state["panes"]) {
            const double x = pane["balls"][0]["pixel"][0], y = pane["balls"][0]["pixel"][1];
            EXPECT_FALSE(x > left && x < right && y > top && y < bottom) << state;
        }
    }
}

}  // namespace
}  // namespace flipside::app
