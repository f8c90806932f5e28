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

// A ball slides down a slope without friction, onto a sensor in the surface of the slope and off it. Rounding
// u of a distance moves these times by the time that the ball takes for √(2ru).
TEST(ReferenceSensors, ThatAreFlushWithASurfaceAreEnteredAndLeftAtTheirEnds) {
    constexpr double gravity = 9.81, radius = 0.1, speed = 1.3;
    for (const double angle : {0.0, 0.02, 0.1, 0.37, 0.5}) {
        Scene scene = empty_scene({0, -gravity});
        const auto at = [&](double along, double above) { return rotated({along, above}, -angle); };
        add_part(scene, segment(at(-1, 0), at(6, 0)));
        add_part(scene, segment(at(1, 0), at(3, 0))).sensor = true;
        add_ball(scene, at(0, radius), rotated({speed, 0}, -angle), radius);
        const auto world = make_world(scene);
        std::vector<double> times;
        for (int step = 0; step < 180; ++step) {
            world->step(1.0 / 60);
            for (const Event& event : world->events())
                if (event.kind == EventKind::sensor_begin || event.kind == EventKind::sensor_end)
                    times.push_back(event.time);
        }
        const double pull = gravity * std::sin(angle);
        const auto passes = [&](double way) {
            return 2 * way / (speed + std::sqrt(speed * speed + 2 * pull * way));
        };
        ASSERT_EQ(times.size(), 2U) << angle;
        EXPECT_NEAR(times[0], passes(1), 1e-7) << angle;
        EXPECT_NEAR(times[1], passes(3), 1e-7) << angle;
    }
}

}  // namespace
}  // namespace flipside::reference::test
