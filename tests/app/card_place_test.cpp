#include "app/window/card_place.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

const Rect panes{0, 100, 600, 400}, window{0, 0, 800, 600};

TEST(CardPlace, BeginsInACornerOfThePanesAndGrowsFromThere) {
    CardPlace place;
    EXPECT_EQ(place.put({100, 50}, panes, window, {}), (Rect{500, 100, 100, 50}));
    EXPECT_EQ(place.put({200, 80}, panes, window, {}), (Rect{400, 100, 200, 80}));
}

TEST(CardPlace, GoesOutOfTheWayAndStaysThere) {
    CardPlace place;
    const Rect ball{550, 120, 20, 20};
    EXPECT_EQ(place.put({100, 50}, panes, window, {&ball, 1}), (Rect{500, 450, 100, 50}));
    EXPECT_EQ(place.put({100, 50}, panes, window, {}), (Rect{500, 450, 100, 50}));
}

TEST(CardPlace, CoversABallRatherThanTheControls) {
    CardPlace place;
    const Rect spots[] = {{0, 100, 100, 400}, {450, 100, 100, 400}};
    EXPECT_EQ(place.put({220, 350}, panes, window, spots), (Rect{380, 100, 220, 350}));
}

TEST(CardPlace, TakesTheLeastOfWhatItCannotAvoid) {
    CardPlace place;
    const Rect spots[] = {{500, 100, 300, 500}, {0, 100, 20, 20}};
    EXPECT_EQ(place.put({400, 390}, panes, window, spots), (Rect{0, 110, 400, 390}));
}

TEST(CardPlace, StaysWhereItIsPutByHandButInTheWindow) {
    CardPlace place;
    place.move_to({300, 300});
    const Rect ball{310, 310, 20, 20};
    EXPECT_EQ(place.put({100, 50}, panes, window, {&ball, 1}), (Rect{300, 300, 100, 50}));
    EXPECT_EQ(place.put({100, 50}, panes, {0, 0, 350, 320}, {&ball, 1}), (Rect{250, 270, 100, 50}));
    EXPECT_EQ(place.put({900, 50}, panes, window, {}), (Rect{0, 300, 900, 50}));
}

}  // namespace
}  // namespace flipside::app
