#include "custom/geometry/capsule.hpp"

#include <gtest/gtest.h>

#include "custom/geometry/narrow_phase.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

double number() {
    return *rc::gen::inRange(-40, 41) * 0.05;
}

Vec2 point() {
    return {number(), number()};
}

// What the exact touch calls an overlap must never be missed, whatever the kind.
RC_GTEST_PROP(Capsule, MissesNothingThatOverlaps, ()) {
    const Vec2 a = point(), center = point();
    const double radius = *rc::gen::inRange(1, 20) * 0.05;
    Vec2 b = point();
    if (b == a) b.x += 1;
    const double wide = 0.2 * length(b - a);
    const Piece pieces[] = {{piece::Point{a}},
                            {piece::Segment{a, b}},
                            {piece::Circle{a, length(b - a)}},
                            {piece::Arc{a, length(b - a), 0.3, 0.3 + *rc::gen::inRange(1, 60) * 0.1}},
                            {piece::Polygon{{a, b, b + perp(b - a)}}},
                            {piece::Taper{a, b, wide, 0.5 * wide}}};
    for (const Piece& piece : pieces) {
        const Touch found = touch(center, radius, piece);
        if (!found.past_end && found.separation < 0)
            RC_ASSERT(overlap(capsule_around(piece), center, radius));
    }
}

// Cores that single precision can't hold, or barely.
TEST(Capsule, MissesNothingAtAnySize) {
    for (const double size : {1e-300, 1e-30, 1e-15, 2e-15, 1e-10, 1e10, 9e14, 1e16, 1e30}) {
        const Vec2 a{size, 2 * size}, b{5 * size, -size};
        const Capsule capsule = capsule_around({piece::Segment{a, b}});
        for (int i = 0; i <= 20; ++i) {
            const Vec2 on_core = a + i / 20.0 * (b - a);
            for (const double side : {-1, 1}) {
                const Vec2 center = on_core + side * 0.999999 * size * unit(perp(b - a));
                EXPECT_TRUE(overlap(capsule, center, size)) << size << " " << i;
            }
        }
    }
}

// Around what is a capsule itself it must be tight: a miss by more than rounding is called a miss.
RC_GTEST_PROP(Capsule, IsTightAroundPointsSegmentsCirclesAndCapsules, ()) {
    const Vec2 a = point(), center = point();
    const double radius = *rc::gen::inRange(1, 20) * 0.05;
    Vec2 b = point();
    if (b == a) b.y += 1;
    const Piece pieces[] = {
        {piece::Point{a}}, {piece::Segment{a, b}}, {piece::Circle{a, 0.3}}, {piece::Taper{a, b, 0.2, 0.2}}};
    for (const Piece& piece : pieces) {
        const double rounding = 1e-10 + 2e-6 * length(b - a);
        if (touch(center, radius, piece).separation > rounding)
            RC_ASSERT(!overlap(capsule_around(piece), center, radius));
    }
}

}  // namespace
}  // namespace flipside::custom
