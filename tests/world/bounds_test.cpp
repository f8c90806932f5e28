#include "world/bounds.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside {
namespace {

using std::numbers::pi;

void expect_box(const Box& box, const Box& expected) {
    EXPECT_NEAR(box.min.x, expected.min.x, 1e-15);
    EXPECT_NEAR(box.min.y, expected.min.y, 1e-15);
    EXPECT_NEAR(box.max.x, expected.max.x, 1e-15);
    EXPECT_NEAR(box.max.y, expected.max.y, 1e-15);
}

TEST(Bounds, OfEachPrimitive) {
    expect_box(bounds_of({1, 2}, 0.5), {{0.5, 1.5}, {1.5, 2.5}});
    expect_box(bounds_of({primitive::Point{{1, 2}}}), {{1, 2}, {1, 2}});
    expect_box(bounds_of({primitive::Segment{{3, 1}, {1, 2}}}), {{1, 1}, {3, 2}});
    expect_box(bounds_of({primitive::Circle{{1, 2}, 3}}), {{-2, -1}, {4, 5}});
    expect_box(bounds_of({primitive::Taper{{0, 0}, {2, 0}, 1, 0.5}}), {{-1, -1}, {2.5, 1}});
    expect_box(bounds_of({primitive::Polygon{{{0, 0}, {2, 1}, {1, 3}}}}), {{0, 0}, {2, 3}});
}

TEST(Bounds, OfArcsTakeInTheOutermostPointsTheyPass) {
    const double s = std::sqrt(0.5);
    expect_box(bounds_of({primitive::Arc{{0, 0}, 1, pi / 4, 3 * pi / 4}}), {{-s, s}, {s, 1}});
    expect_box(bounds_of({primitive::Arc{{0, 0}, 1, -pi / 4, pi / 4}}), {{s, -s}, {1, s}});
    expect_box(bounds_of({primitive::Arc{{0, 0}, 1, 0, 2 * pi}}), {{-1, -1}, {1, 1}});
    expect_box(bounds_of({primitive::Arc{{0, 0}, 1, pi / 8, pi / 4}}),
               {{s, std::sin(pi / 8)}, {std::cos(pi / 8), s}});
}

TEST(Bounds, FollowThePose) {
    const Pose quarter{{1, 0}, pi / 2};
    expect_box(bounds_of({primitive::Segment{{1, 0}, {3, 0}}}, quarter), {{1, 0}, {1, 2}});
    expect_box(bounds_of({primitive::Arc{{1, 0}, 1, -pi / 4, pi / 4}}, quarter),
               {{1 - std::sqrt(0.5), std::sqrt(0.5)}, {1 + std::sqrt(0.5), 1}});
}

RC_GTEST_PROP(Bounds, ArcBoxHoldsEveryPointAndIsTight, ()) {
    const double from = *rc::gen::inRange(-7000, 7000) * 1e-3;
    const double to = from + *rc::gen::inRange(1, 6283) * 1e-3;
    const double turn = *rc::gen::inRange(-3000, 3000) * 1e-3;
    const Box box = bounds_of({primitive::Arc{{0, 0}, 2, from, to}}, Pose{{0, 0}, turn});
    Box seen{{9, 9}, {-9, -9}};
    for (int i = 0; i <= 1000; ++i) {
        const Vec2 p = 2 * from_angle(turn + from + (to - from) * i / 1000);
        RC_ASSERT(grown(box, 1e-12).contains(p));
        seen = united(seen, {p, p});
    }
    RC_ASSERT(grown(seen, 1e-4).contains(box.min));
    RC_ASSERT(grown(seen, 1e-4).contains(box.max));
}

TEST(Bounds, BoxesThatShareABorderOverlap) {
    const Box a{{0, 0}, {1, 1}};
    EXPECT_TRUE(overlap(a, {{1, 1}, {2, 2}}));
    EXPECT_FALSE(overlap(a, {{1.001, 0}, {2, 1}}));
    EXPECT_FALSE(overlap(a, {{0, -1}, {1, -0.001}}));
    EXPECT_TRUE(overlap(a, {{0.5, 0.5}, {0.5, 0.5}}));
}

}  // namespace
}  // namespace flipside
