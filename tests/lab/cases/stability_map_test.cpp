#include "lab/cases/stability_map.hpp"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"

namespace flipside::lab {
namespace {

std::vector<StabilityPoint> map_of(const Contender& contender) {
    double done = 0;
    auto points = stability_map(contender, map_steps, [&](double share) { done = share; });
    EXPECT_EQ(done, 1);
    EXPECT_EQ(points.size(), std::size(map_mass_ratios) * std::size(map_speeds) * std::size(map_steps));
    return points;
}

Contender contender_of(std::string_view engine) {
    const Engine& chosen = engine_named(engine);
    return {&chosen, settings_for(chosen, Scene{})};
}

void expect_holds(const StabilityPoint& point) {
    EXPECT_EQ(point.failure, "") << point.mass_ratio << " " << point.speed << " " << point.dt;
    EXPECT_LE(point.energy_gain, 0.01);
    EXPECT_LE(point.overlap, 0.1);
}

// Balls of like mass at the speeds of a pinball hold at every step.
TEST(StabilityMaps, gentleThrowsHoldOnBox2d) {
    for (const StabilityPoint& point : map_of(contender_of("box2d"))) {
        EXPECT_NE(point.failure, "not a number");
        if (point.mass_ratio <= 100 && point.speed <= 10) expect_holds(point);
    }
}

// A heavy ball presses a light one into the floor at any speed, and never through it.
TEST(StabilityMaps, theBespokeEngineHoldsEverywhere) {
    for (const StabilityPoint& point : map_of(contender_of("custom"))) expect_holds(point);
}

TEST(StabilityMaps, csvHasARowPerPoint) {
    const StabilityPoint points[] = {{1, 10, 0.25, "", -0.5, 0}, {100, 1000, 0.5, "escape", 2, 0.125}};
    std::ostringstream out;
    write_stability(out, contender_of("box2d"), points);
    EXPECT_EQ(out.str(), std::string(stability_header) +
                             "box2d,1,10,0.25,1,,-0.5,0\n"
                             "box2d,100,1000,0.5,0,escape,2,0.125\n");
}

}  // namespace
}  // namespace flipside::lab
