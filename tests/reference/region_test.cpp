// When a ball is in a sensor, on the exact engine.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "reference/support.hpp"

namespace flipside::reference::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

// The arc turns past a ball at rest, which leaves it where its end is a radius away.
TEST(ReferenceSensors, ATurningArcIsLeftAtItsEnd) {
    const double radius = 0.05, to = 60 * degree;
    for (const double sweep : {1.0, 40.0, 90.0, 150.0, 180.0, 181.0, 250.0, 350.0}) {
        Scene scene = empty_scene();
        Part& part = add_part(scene, {shape::Arc{{0, 0}, 1, to - sweep * degree, to}});
        part.sensor = true;
        part.motion = motion::Turn{{0, 0}, -1, true};
        add_ball(scene, {1, 0}, {}, radius);
        const auto world = make_world(scene);
        double begin = 0, end = 0;
        for (int step = 0; step < 240; ++step) {
            world->step(1.0 / 120);
            for (const Event& event : world->events()) {
                if (event.kind == EventKind::sensor_begin && end == 0) begin = event.time;
                if (event.kind == EventKind::sensor_end) end = event.time;
            }
        }
        const double reach = 2 * std::asin(radius / 2);
        EXPECT_NEAR(begin, std::max(0.0, to - sweep * degree - reach), 1e-12) << sweep;
        EXPECT_NEAR(end, to + reach, 1e-12) << sweep;
    }
}

}  // namespace
}  // namespace flipside::reference::test
