// A weightless ball that leaves a straight face for the cap, arc or corner at its end: a straight line.

#include <gtest/gtest.h>

#include "joint_scenes.hpp"
#include "reference/support.hpp"

namespace flipside::reference::test {
namespace {

using flipside::test::Placement;
using flipside::test::Slide;

void expect_straight(Placement place, int orientations, double dt, std::string_view precision = "53") {
    for (int k = 0; k < orientations; ++k) {
        place.angle = 0.1 + 2 * std::numbers::pi * k / orientations;
        for (const Slide& slide : flipside::test::slides(place)) {
            // What is as wide as the ball in double is narrower in a wider type.
            if (precision != "53" && slide.name == "channel") continue;
            const auto world = make_world(slide.scene, {{"precision", precision}});
            EXPECT_LE(flipside::test::strays(*world, slide, dt), 1e-12 * (1 + length(place.origin)))
                << slide.name << ", angle " << place.angle;
        }
    }
}

TEST(ReferenceSmoothJoint, IsAStraightLineAtEveryStep) {
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 97, 1.0 / 240, 1.0 / 1000}) expect_straight({}, 60, dt);
}

TEST(ReferenceSmoothJoint, IsAStraightLineOfOtherSizesAtOtherPlaces) {
    const Placement places[] = {
        {0, {}, 0.0135, 6}, {0, {30, -17}, 0.1, 1}, {0, {-2, 3}, 5, 1e3}, {0, {1, 1}, 1e-3, 1e-3}};
    for (const Placement& place : places) expect_straight(place, 40, place.radius / place.speed);
}

// States are rounded to double; a ball that touches by that much touches in a wider type, too.
TEST(ReferenceSmoothJoint, IsAStraightLineInAWiderType) {
    expect_straight({}, 10, 1.0 / 60, "113");
}

}  // namespace
}  // namespace flipside::reference::test
