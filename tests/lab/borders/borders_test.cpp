#include "lab/borders/borders.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"

namespace flipside::lab {
namespace {

Contender contender(const std::string& engine, const std::vector<std::string>& changes = {}) {
    const Engine* const used = &engine_named(engine);
    return {used, settings_for(*used, Scene{}, parse_changes(changes, {&used, 1}))};
}

/// The points of one border, of which all but the last hold.
std::vector<BorderPoint> points_of(const std::vector<BorderPoint>& all, std::string_view border) {
    std::vector<BorderPoint> points;
    std::ranges::copy_if(all, std::back_inserter(points),
                         [&](const BorderPoint& p) { return p.border == border; });
    return points;
}

TEST(Borders, EachClimbsItsLadderUntilTheFirstThatBreaks) {
    double last = 0;
    const auto found = find_borders(contender("custom", {"solver=simple"}), whole_ladders, [&](double share) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1);
        last = share;
    });
    for (const Border& border : borders()) {
        const auto points = points_of(found, border.name);
        ASSERT_FALSE(points.empty()) << border.name;
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(points[i].value, border.ladder[i]) << border.name;
            EXPECT_EQ(points[i].failure.empty(),
                      i + 1 < points.size() || points.size() == border.ladder.size())
                << border.name << ' ' << points[i].value << ": " << points[i].failure;
        }
    }
    // The toy's loop lets go of what moves on by more than a few radii in a step.
    const auto at_walls = points_of(found, "wall-speed");
    EXPECT_EQ(at_walls.back().failure, "a ball gets out");
    EXPECT_LT(at_walls.back().value, 100);
}

TEST(Borders, SayWhatBreaks) {
    const auto box2d = find_borders(contender("box2d"), whole_ladders, [](double) {});
    EXPECT_NE(points_of(box2d, "heavy-on-light").back().failure.find("overlap of"), std::string::npos);
    // It moves nothing by more than two of its units in a step, and so slows fast balls down.
    EXPECT_NE(points_of(box2d, "wall-speed").back().failure.find("loses"), std::string::npos);
    const auto exact = find_borders(contender("reference"), whole_ladders, [](double) {});
    // It knows the forces in a stack that is at rest.
    EXPECT_EQ(points_of(exact, "stack").back().failure, "");
    EXPECT_EQ(points_of(exact, "wall-speed").back().failure, "");
}

TEST(Borders, HeightCountsFromTheFloor) {
    // The balls of the hunted scene start at about the height 0, and fall below it: their energy is no gain.
    for (const char* engine : {"custom", "box2d"}) {
        const auto points = points_of(find_borders(contender(engine), 1, [](double) {}), "hunted");
        EXPECT_EQ(points.front().failure.find("energy"), std::string::npos) << engine;
    }
}

}  // namespace
}  // namespace flipside::lab
