// The smallest enclosing circle and rectangle, against slow searches.

#include "custom/geometry/enclosing.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

constexpr double rounding = 1e-9;

/// Few whole numbers, so that some points coincide or lie on a line.
std::vector<Vec2> any_points(int least) {
    std::vector<Vec2> points(static_cast<std::size_t>(*rc::gen::inRange(least, 14)));
    for (Vec2& p : points) p = {double(*rc::gen::inRange(-6, 7)), double(*rc::gen::inRange(-6, 7))};
    return points;
}

bool encloses(const Disc& disc, std::span<const Vec2> points) {
    return std::ranges::all_of(points,
                               [&](Vec2 p) { return length(p - disc.center) <= disc.radius + rounding; });
}

/// The smallest circle has two of the points at the ends of a diameter or goes through three of them.
double least_radius(const std::vector<Vec2>& points) {
    double least = points.size() == 1 ? 0 : 1e9;
    const auto offer = [&](const Disc& disc) {
        if (encloses(disc, points)) least = std::min(least, disc.radius);
    };
    for (const Vec2 a : points)
        for (const Vec2 b : points) {
            offer({0.5 * (a + b), 0.5 * length(b - a)});
            for (const Vec2 c : points) {
                const double d = 2 * cross(b - a, c - a);
                if (d == 0) continue;
                const double b2 = length_squared(b - a), c2 = length_squared(c - a);
                const Vec2 center =
                    a + Vec2{(c.y - a.y) * b2 - (b.y - a.y) * c2, (b.x - a.x) * c2 - (c.x - a.x) * b2} / d;
                offer({center, length(center - a)});
            }
        }
    return least;
}

/// The least rectangle has a side in the direction between two of the points.
double least_area(const std::vector<Vec2>& points) {
    double least = 1e9;
    for (const Vec2 a : points)
        for (const Vec2 b : points) {
            if (a == b) continue;
            const Vec2 along = unit(b - a);
            const auto extent = [&](Vec2 direction) {
                const auto [low, high] =
                    std::ranges::minmax(points, {}, [&](Vec2 p) { return dot(p, direction); });
                return dot(high - low, direction);
            };
            least = std::min(least, extent(along) * extent(perp(along)));
        }
    return least;
}

RC_GTEST_PROP(Enclosing, DiscIsTheSmallest, ()) {
    const auto points = any_points(1);
    const Disc disc = enclosing_disc(points);
    RC_ASSERT(encloses(disc, points));
    RC_ASSERT(std::abs(disc.radius - least_radius(points)) < rounding);
}

RC_GTEST_PROP(Enclosing, HullIsConvexAndEnclosesAll, ()) {
    const auto points = any_points(1);
    const auto hull = convex_hull(points);
    for (std::size_t i = 0; hull.size() > 2 && i < hull.size(); ++i) {
        const Vec2 a = hull[i], b = hull[(i + 1) % hull.size()], c = hull[(i + 2) % hull.size()];
        RC_ASSERT(cross(b - a, c - b) > 0);
        for (const Vec2 p : points) RC_ASSERT(cross(b - a, p - a) >= 0);
    }
    for (const Vec2 corner : hull) RC_ASSERT(std::ranges::find(points, corner) != points.end());
}

RC_GTEST_PROP(Enclosing, RectangleIsTheLeast, ()) {
    const auto points = any_points(2);
    RC_PRE(std::ranges::any_of(points, [&](Vec2 p) { return p != points.front(); }));
    const Rectangle found = enclosing_rectangle(points);
    for (const Vec2 p : points) {
        RC_ASSERT(std::abs(dot(p - found.center, found.along)) <= found.half.x + rounding);
        RC_ASSERT(std::abs(dot(p - found.center, perp(found.along))) <= found.half.y + rounding);
    }
    RC_ASSERT(std::abs(4 * found.half.x * found.half.y - least_area(points)) < rounding);
}

TEST(Enclosing, KnownShapes) {
    const std::vector<Vec2> tilted{{0, 0}, {4, 4}, {3, 5}, {-1, 1}, {1, 2}};
    const Rectangle rectangle = enclosing_rectangle(tilted);
    EXPECT_NEAR(rectangle.half.x * rectangle.half.y, std::sqrt(8.0) * std::sqrt(0.5), rounding);
    for (const Vec2 corner : rectangle.corners())
        EXPECT_TRUE(std::ranges::any_of(tilted, [&](Vec2 p) { return length(p - corner) < rounding; }));
    const Disc disc = enclosing_disc(tilted);
    EXPECT_NEAR(disc.radius, 0.5 * std::sqrt(34.0), rounding);  // from (0, 0) to (3, 5)
}

TEST(Enclosing, OutlinesEncloseRoundPrimitivesTightly) {
    const Pose pose{{1, 2}, 0.7};
    std::vector<Vec2> points;
    append_outline({primitive::Circle{{3, 1}, 2}, 0}, pose, points);
    Disc disc = enclosing_disc(points);
    EXPECT_NEAR(length(disc.center - pose.apply({3, 1})), 0, rounding);
    EXPECT_GE(disc.radius, 2);
    EXPECT_LT(disc.radius, 2 * 1.0013);

    points.clear();
    append_outline({primitive::Arc{{0, 0}, 1, 0, std::numbers::pi}, 0}, {}, points);
    const Rectangle half = enclosing_rectangle(points);
    EXPECT_GE(4 * half.half.x * half.half.y, 2 - rounding);
    EXPECT_LT(4 * half.half.x * half.half.y, 2 * 1.003);
    points.clear();
    append_outline({primitive::Taper{{0, 0}, {4, 0}, 1, 0.5}, 0}, {}, points);
    disc = enclosing_disc(points);
    EXPECT_NEAR(disc.radius, 5.5 / 2, 0.0013);  // from −1 to 4.5
}

}  // namespace
}  // namespace flipside::custom
