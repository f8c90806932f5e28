// Boxes in single precision miss nothing that the exact ones meet, and add little.

#include "custom/geometry/single_box.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "custom/geometry/bounds.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

double any_side() {
    return *rc::gen::inRange(-40, 41) * 0.1;
}

Box any_box() {
    const Vec2 min{any_side(), any_side()};
    return {min, min + Vec2{std::abs(any_side()), std::abs(any_side())}};
}

double gap(const Box& a, const Box& b) {
    return std::max({a.min.x - b.max.x, b.min.x - a.max.x, a.min.y - b.max.y, b.min.y - a.max.y});
}

RC_GTEST_PROP(SingleBox, OverlapsAndHoldsWhatTheExactBoxDoes, ()) {
    const Box a = any_box(), b = any_box();
    const SingleBox single_a = a, single_b = b;
    RC_ASSERT(holds(Box(single_a), a));
    RC_ASSERT(holds(grown(a, 4e-7 * 8), Box(single_a)));
    if (overlap(a, b)) RC_ASSERT(overlap(single_a, single_b));
    if (gap(a, b) > 4e-7 * 16) RC_ASSERT(!overlap(single_a, single_b));
    if (holds(a, b)) RC_ASSERT(holds(single_a, single_b));
    RC_ASSERT(overlap(single_a, single_b) == overlap(Box(single_a), Box(single_b)));
    RC_ASSERT(holds(single_a, single_b) == holds(Box(single_a), Box(single_b)));
}

TEST(SingleBox, HoldsItsBoxAtAnyPlace) {
    for (const double place : {0.0, 1e-300, 1e-40, 1e-38, 1.0, 16777217.0, 1e9, 3.5e38, 1e300})
        for (const double sign : {-1.0, 1.0})
            for (const double size : {0.0, 1e-9, 1.0, 1e39}) {
                const double x = sign * place;
                const Box box{{x, -x}, {x + size, -x + size}};
                const SingleBox single = box;
                EXPECT_TRUE(overlap(single, single)) << x << " " << size;
                if (place + size > 1e38) continue;  // its sides are at infinity
                EXPECT_TRUE(holds(Box(single), box)) << x << " " << size;
            }
}

TEST(SingleBox, NoneOverlapsWhatIsNotANumber) {
    const SingleBox nowhere(Vec2{NAN, 0}, Vec2{NAN, 1}), box(Vec2{-1, -1}, Vec2{1, 1});
    EXPECT_FALSE(overlap(nowhere, box));
    EXPECT_FALSE(holds(box, nowhere));
}

}  // namespace
}  // namespace flipside::custom
