#include "custom/geometry/narrow_phase.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

using std::numbers::pi;

using custom::touch;
template <class Kind>
Touch touch(Vec2 center, double radius, const Kind& kind) {
    return touch(center, radius, Primitive{kind});
}

void expect_touch(const Touch& found, Vec2 point, Vec2 normal, double separation) {
    EXPECT_NEAR(found.point.x, point.x, 1e-14);
    EXPECT_NEAR(found.point.y, point.y, 1e-14);
    EXPECT_NEAR(found.normal.x, normal.x, 1e-14);
    EXPECT_NEAR(found.normal.y, normal.y, 1e-14);
    EXPECT_NEAR(found.separation, separation, 1e-14);
}

TEST(NarrowPhase, Point) {
    const Touch found = touch({3, 4}, 2, primitive::Point{{0, 0}});
    expect_touch(found, {0, 0}, {0.6, 0.8}, 3);
    expect_touch(touch({1, 1}, 2, primitive::Point{{1, 1}}), {1, 1}, {0, 1}, -2);
}

TEST(NarrowPhase, SegmentFromBothSides) {
    const primitive::Segment floor{{-1, 0}, {1, 0}};
    expect_touch(touch({0.5, 0.3}, 0.5, floor), {0.5, 0}, {0, 1}, -0.2);
    expect_touch(touch({0.5, -0.3}, 0.5, floor), {0.5, 0}, {0, -1}, -0.2);
    const Touch on_it = touch({0, 0}, 0.5, floor);
    EXPECT_NEAR(on_it.separation, -0.5, 1e-15);
    EXPECT_NEAR(std::abs(on_it.normal.y), 1, 1e-15);
}

TEST(NarrowPhase, SegmentEndsAreNotTheFace) {
    const primitive::Segment floor{{-1, 0}, {1, 0}};
    EXPECT_FALSE(touch({1, 0.3}, 0.5, floor).past_end);
    const Touch beyond = touch({4, 4}, 2, floor);
    EXPECT_TRUE(beyond.past_end);
    expect_touch(beyond, {1, 0}, {0.6, 0.8}, 3);
}

TEST(NarrowPhase, ArcFromBothSidesAndBeyondItsEnds) {
    const primitive::Arc quarter{{1, 1}, 2, 0, pi / 2};
    const double s = std::sqrt(0.5);
    const Touch outside = touch({1 + 3 * s, 1 + 3 * s}, 0.5, quarter);
    expect_touch(outside, {1 + 2 * s, 1 + 2 * s}, {s, s}, 0.5);
    const Touch inside = touch({1 + s, 1 + s}, 0.5, quarter);
    expect_touch(inside, {1 + 2 * s, 1 + 2 * s}, {-s, -s}, 0.5);
    const Touch beyond = touch({3, -1}, 0.5, quarter);
    EXPECT_TRUE(beyond.past_end);
    expect_touch(beyond, {3, 1}, {0, -1}, 1.5);
    // All points of the arc are equally close to the centre; the result is its middle.
    expect_touch(touch({1, 1}, 0.5, quarter), {1 + 2 * s, 1 + 2 * s}, {-s, -s}, 1.5);
}

TEST(NarrowPhase, ArcAcrossTheCutOfTheAngle) {
    const primitive::Arc left{{0, 0}, 1, 3 * pi / 4, 5 * pi / 4};
    EXPECT_FALSE(touch({-2, 0}, 0.1, left).past_end);
    EXPECT_FALSE(touch({-2, -1e-9}, 0.1, left).past_end);
    EXPECT_TRUE(touch({2, 0}, 0.1, left).past_end);
    const primitive::Arc wound{{0, 0}, 1, -pi / 4 - 2 * pi, pi / 4 - 2 * pi};
    EXPECT_FALSE(touch({2, 0}, 0.1, wound).past_end);
    EXPECT_TRUE(touch({-2, 0}, 0.1, wound).past_end);
}

TEST(NarrowPhase, CircleAlsoFromWithin) {
    expect_touch(touch({5, 0}, 1, primitive::Circle{{0, 0}, 2}), {2, 0}, {1, 0}, 2);
    expect_touch(touch({0, 0.5}, 1, primitive::Circle{{0, 0}, 2}), {0, 2}, {0, 1}, -2.5);
    expect_touch(touch({0, 0}, 1, primitive::Circle{{0, 0}, 2}), {0, 2}, {0, 1}, -3);
}

TEST(NarrowPhase, PolygonFacesCornersAndInside) {
    const primitive::Polygon square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
    expect_touch(touch({3, 1}, 0.5, square), {2, 1}, {1, 0}, 0.5);
    expect_touch(touch({5, 6}, 1, square), {2, 2}, {0.6, 0.8}, 4);
    expect_touch(touch({1.75, 1}, 0.5, square), {2, 1}, {1, 0}, -0.75);
}

TEST(NarrowPhase, TaperSidesAndEnds) {
    const primitive::Taper capsule{{0, 0}, {4, 0}, 1, 1};
    expect_touch(touch({2, 3}, 0.5, capsule), {2, 1}, {0, 1}, 1.5);
    expect_touch(touch({2, -3}, 0.5, capsule), {2, -1}, {0, -1}, 1.5);
    expect_touch(touch({7, 4}, 1, capsule), {4.6, 0.8}, {0.6, 0.8}, 3);
    expect_touch(touch({-3, 0}, 1, capsule), {-1, 0}, {-1, 0}, 1);
    // Radii 2 and 1, 2 apart: the tangents lean by 30 degrees.
    const primitive::Taper flipper{{0, 0}, {2, 0}, 2, 1};
    const Vec2 lean = from_angle(pi / 3);
    const Vec2 on_side = 2 * lean + 0.5 * Vec2{lean.y, -lean.x};
    expect_touch(touch(on_side + 3 * lean, 1, flipper), on_side, lean, 2);
}

TEST(NarrowPhase, Discs) {
    expect_touch(touch({0, 3}, 1, {0, 0}, 1.5), {0, 1.5}, {0, 1}, 0.5);
}

/// Points on the surface of a primitive, closer together than `step`.
std::vector<Vec2> samples(const Primitive& primitive, double step) {
    struct Sample {
        double step;
        std::vector<Vec2> points;
        void line(Vec2 a, Vec2 b) {
            const int n = static_cast<int>(length(b - a) / step) + 1;
            for (int i = 0; i <= n; ++i) points.push_back(a + (double(i) / n) * (b - a));
        }
        void round(Vec2 center, double radius, double from, double to) {
            const int n = static_cast<int>((to - from) * radius / step) + 1;
            for (int i = 0; i <= n; ++i)
                points.push_back(center + radius * from_angle(from + (to - from) * i / n));
        }
        void operator()(const primitive::Point& p) { points.push_back(p.at); }
        void operator()(const primitive::Segment& p) { line(p.a, p.b); }
        void operator()(const primitive::Arc& p) { round(p.center, p.radius, p.from, p.to); }
        void operator()(const primitive::Circle& p) { round(p.center, p.radius, 0, 2 * pi); }
        void operator()(const primitive::Polygon& p) {
            for (std::size_t i = 0; i < p.points.size(); ++i)
                line(p.points[i], p.points[(i + 1) % p.points.size()]);
        }
        void operator()(const primitive::Taper& p) {
            const double axis = angle_of(p.b - p.a);
            const double lean = std::acos((p.radius_a - p.radius_b) / length(p.b - p.a));
            round(p.a, p.radius_a, axis + lean, axis + 2 * pi - lean);
            round(p.b, p.radius_b, axis - lean, axis + lean);
            for (const double side : {lean, -lean}) {
                const Vec2 normal = from_angle(axis + side);
                line(p.a + p.radius_a * normal, p.b + p.radius_b * normal);
            }
        }
    };
    Sample sample{step, {}};
    std::visit([&](const auto& kind) { sample(kind); }, primitive.is);
    return sample.points;
}

double coordinate() {
    return *rc::gen::inRange(-3000, 3000) * 1e-3;
}
Vec2 any_place() {
    const double x = coordinate();
    return {x, coordinate()};
}
double size() {
    return *rc::gen::inRange(10, 1500) * 1e-3;
}

/// For all primitives, the point lies on the surface and no sample is closer. Inside a solid the separation
/// is the negative distance from the closest surface.
void check_against_samples(const Primitive& primitive, bool solid) {
    const Vec2 center = any_place();
    const double radius = size();
    const Pose pose{any_place(), *rc::gen::inRange(-3, 4) * 0.9};
    const Touch found = touch(center, radius, primitive, pose);
    constexpr double step = 2e-3;
    double nearest = 1e9, to_point = 1e9;
    for (const Vec2 sample : samples(primitive, step)) {
        nearest = std::min(nearest, length(pose.apply(sample) - center));
        to_point = std::min(to_point, length(pose.apply(sample) - found.point));
    }
    const double distance = found.separation + radius;
    if (!solid) RC_ASSERT(distance >= -1e-12);
    RC_ASSERT(std::abs(length(found.point - center) - std::abs(distance)) < 1e-9);
    RC_ASSERT(std::abs(length(found.normal) - 1) < 1e-12);
    RC_ASSERT(length(center - found.point - distance * found.normal) < 1e-9);
    RC_ASSERT(std::abs(distance) <= nearest + 1e-12);
    RC_ASSERT(std::abs(distance) >= nearest - step);
    RC_ASSERT(to_point <= step);
}

RC_GTEST_PROP(NarrowPhase, SegmentAgreesWithSamples, ()) {
    const Vec2 a = any_place();
    check_against_samples({primitive::Segment{a, a + size() * from_angle(coordinate())}}, false);
}
RC_GTEST_PROP(NarrowPhase, ArcAgreesWithSamples, ()) {
    const Vec2 center = any_place();
    const double from = coordinate();
    check_against_samples({primitive::Arc{center, size(), from, from + *rc::gen::inRange(10, 6283) * 1e-3}},
                          false);
}
RC_GTEST_PROP(NarrowPhase, CircleAgreesWithSamples, ()) {
    const Vec2 center = any_place();
    check_against_samples({primitive::Circle{center, size()}}, true);
}
RC_GTEST_PROP(NarrowPhase, PolygonAgreesWithSamples, ()) {
    // Corners on an ellipse, in order, are convex.
    const int corners = *rc::gen::inRange(3, 9);
    const double width = 0.1 + size(), height = 0.1 + size();
    const Vec2 center = any_place();
    primitive::Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const Vec2 out = from_angle((i + *rc::gen::inRange(0, 800) * 1e-3) * 2 * pi / corners);
        polygon.points.push_back(center + Vec2{width * out.x, height * out.y});
    }
    check_against_samples({polygon}, true);
}
RC_GTEST_PROP(NarrowPhase, TaperAgreesWithSamples, ()) {
    const double a = size(), b = size();
    const Vec2 at = any_place();
    const Vec2 along = (std::abs(a - b) + size()) * from_angle(coordinate());
    check_against_samples({primitive::Taper{at, at + along, a, b}}, true);
}

}  // namespace
}  // namespace flipside::custom
