// Without gravity, a ball that slides off a straight face onto the cap, arc or corner at its end moves on a
// straight line.

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "joint_scenes.hpp"

namespace flipside::custom::test {
namespace {

using flipside::test::Placement;
using flipside::test::Slide;

/// Deviation from a straight line with steps of dt, over all orientations, in radii.
double worst_of(Placement place, int orientations, double dt) {
    double worst = 0;
    for (int k = 0; k < orientations; ++k) {
        place.angle = 0.1 + 2 * std::numbers::pi * k / orientations;
        for (const Slide& slide : flipside::test::slides(place)) {
            const auto world = make_world(slide.scene, {{"solver", "continuous"}});
            const double strayed = flipside::test::strays(*world, slide, dt);
            // Positions are rounded once in each window of the solver.
            const double rounding = 60 * slide.seconds * 0x1p-53 * length(place.origin) / place.radius;
            EXPECT_LE(strayed, 1e-12 * (1 + length(place.origin)) + rounding)
                << slide.name << ", angle " << place.angle;
            worst = std::max(worst, strayed);
        }
    }
    return worst;
}

TEST(SmoothJoint, IsAStraightLineAtEveryStep) {
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 97, 1.0 / 240, 1.0 / 1000})
        std::printf("worst at 1/%.0f s: %.2g r\n", 1 / dt, worst_of({}, 60, dt));
}

TEST(SmoothJoint, IsAStraightLineForOtherSizesAndPositions) {
    const Placement places[] = {
        {0, {}, 0.0135, 6}, {0, {30, -17}, 0.1, 1}, {0, {-2, 3}, 5, 1e3}, {0, {1, 1}, 1e-3, 1e-3}};
    for (const Placement& place : places) worst_of(place, 40, place.radius / place.speed);
}

}  // namespace
}  // namespace flipside::custom::test
