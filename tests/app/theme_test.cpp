// The colours of the window: what is shown together can be told apart, and an engine keeps its hue.

#include "app/window/theme.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "app/window/contender_colour.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {
namespace {

/// Between two colours, in steps of 1 of 255 of red, green and blue.
double colour_distance(sf::Color a, sf::Color b) {
    return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b);
}

/// Degrees.
double hue_of(sf::Color c) {
    const double y = std::sqrt(3.0) * (c.g - c.b), x = 2.0 * c.r - c.g - c.b;
    return std::atan2(y, x) * 180 / std::numbers::pi;
}

TEST(Theme, WhatIsDrawnTogetherHasColoursOfItsOwn) {
    std::vector<sf::Color> shown{colour::boxes,    colour::cells,   colour::pairs, colour::sectors,
                                 colour::tangents, colour::warning, colour::lit};
    for (const char* engine : {"custom", "box2d", "reference"}) shown.push_back(engine_colour(engine));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_GT(colour_distance(shown[i], colour::table), 100) << i;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(colour_distance(shown[i], shown[j]), 50) << i << " and " << j;
    }
}

TEST(Theme, ContendersOnOneEngineKeepItsHue) {
    for (const std::string engine : {"custom", "box2d", "reference"}) {
        const Stage stage("drop", "custom", View::split, {}, {},
                          std::vector{"a=" + engine, "b=" + engine, "c=" + engine, "d=" + engine});
        std::vector<sf::Color> shown;
        for (const auto& run : stage.runs()) shown.push_back(colour_of(run));
        ASSERT_EQ(shown.size(), 4U);
        EXPECT_EQ(shown[0], engine_colour(engine));
        for (std::size_t i = 0; i < shown.size(); ++i) {
            EXPECT_NEAR(hue_of(shown[i]), hue_of(shown[0]), 5) << engine << " " << i;
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT(colour_distance(shown[i], shown[j]), 35) << engine << " " << i << " and " << j;
        }
    }
}

}  // namespace
}  // namespace flipside::app
