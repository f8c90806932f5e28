#include "custom/geometry/polygon_contact.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

std::vector<Vec2> box(Vec2 min, Vec2 max) {
    return {min, {max.x, min.y}, max, {min.x, max.y}};
}

TEST(PolygonContact, FaceOnFaceHasTwoPoints) {
    const PolygonContact contact = polygon_contact(box({0, 0}, {2, 1}), box({1, 0.75}, {3, 2}));
    EXPECT_EQ(contact.normal, (Vec2{0, 1}));
    EXPECT_NEAR(contact.separation, -0.25, 1e-15);
    ASSERT_EQ(contact.count, 2);
    EXPECT_NEAR(std::min(contact.points[0].x, contact.points[1].x), 1, 1e-15);
    EXPECT_NEAR(std::max(contact.points[0].x, contact.points[1].x), 2, 1e-15);
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(contact.points[i].y, 0.75, 1e-15);
        EXPECT_NEAR(contact.separations[i], -0.25, 1e-15);
    }
}

TEST(PolygonContact, CornerOnFaceHasOnePoint) {
    const std::vector<Vec2> diamond{{1, 0.9}, {2, 2}, {1, 3}, {0, 2}};
    const PolygonContact contact = polygon_contact(box({-2, 0}, {4, 1}), diamond);
    EXPECT_EQ(contact.normal, (Vec2{0, 1}));
    ASSERT_EQ(contact.count, 1);
    EXPECT_NEAR(contact.points[0].x, 1, 1e-15);
    EXPECT_NEAR(contact.points[0].y, 0.9, 1e-15);
    EXPECT_NEAR(contact.separations[0], -0.1, 1e-15);
}

TEST(PolygonContact, ApartHasNone) {
    const PolygonContact contact = polygon_contact(box({0, 0}, {1, 1}), box({2.5, 0}, {3, 1}));
    EXPECT_EQ(contact.count, 0);
    EXPECT_EQ(contact.normal, (Vec2{1, 0}));
    EXPECT_NEAR(contact.separation, 1.5, 1e-15);
}

std::vector<Vec2> random_polygon() {
    const int corners = *rc::gen::inRange(3, 8);
    const double turn = *rc::gen::inRange(0, 6283) * 1e-3;
    const double size = *rc::gen::inRange(300, 1500) * 1e-3;
    const double x = *rc::gen::inRange(-1500, 1500) * 1e-3;
    const Vec2 center{x, *rc::gen::inRange(-1500, 1500) * 1e-3};
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i)
        points.push_back(center + size * from_angle(turn + i * 2 * std::numbers::pi / corners));
    return points;
}

bool disjoint_after(const std::vector<Vec2>& a, std::vector<Vec2> b, Vec2 shift) {
    for (Vec2& corner : b) corner += shift;
    return polygon_contact(a, b).separation > 0;
}

/// The depth is the least push that parts the two.
RC_GTEST_PROP(PolygonContact, DepthIsTheLeastPushApart, ()) {
    const std::vector<Vec2> a = random_polygon(), b = random_polygon();
    const PolygonContact contact = polygon_contact(a, b);
    if (contact.separation > 0) return;
    RC_ASSERT(contact.count >= 1);
    RC_ASSERT(disjoint_after(a, b, (-contact.separation + 1e-9) * contact.normal));
    for (int i = 0; i < 64; ++i) {
        const Vec2 any = from_angle(i * std::numbers::pi / 32);
        RC_ASSERT(!disjoint_after(a, b, (-contact.separation - 1e-9) * any));
    }
    const PolygonContact swapped = polygon_contact(b, a);
    RC_ASSERT(std::abs(swapped.separation - contact.separation) < 1e-12);
}

}  // namespace
}  // namespace flipside::custom
