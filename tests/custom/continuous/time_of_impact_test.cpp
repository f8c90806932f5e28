// Closed forms against the general search, on random placements.

#include "custom/continuous/time_of_impact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "custom/between.hpp"
#include "custom/continuous/arc.hpp"

namespace flipside::custom::test {
namespace {

std::uint64_t steps = 0;  ///< of all searches

Vec2 anywhere(double size) {
    return {between(-size, size), between(-size, size)};
}
Path random_path(Vec2 gravity) {
    Path path;
    path.flight = {anywhere(2), anywhere(5), gravity, 0};
    return path;
}

/// Both agree, or one of them misses a grazing contact.
void same(double closed, double searched, double approach) {
    if (closed == never_touch && searched == never_touch) return;
    if (std::abs(approach) < 1e-5) return;
    RC_ASSERT(std::abs(closed - searched) < 1e-9);
}

RC_GTEST_PROP(TimeOfImpact, ClosedFormForALineAgreesWithTheSearch, ()) {
    const Vec2 a = anywhere(2), b = anywhere(2);
    RC_PRE(length(b - a) > 0.01);
    const Feature line{Line{a, unit(b - a), length(b - a), {}, {}}, 0, 0};
    Path path = random_path(anywhere(10));
    path.flight.drag = *rc::gen::element(0.0, 1e-9, 0.05, 1.0, 20.0);
    const double r = between(0.01, 0.3), end = 1;
    RC_PRE(closest_point(line, path.flight.position, r).distance > r + 1e-6);
    const double closed = time_of_impact(line, {}, path, r, 0, end, steps);
    const double searched = search_impact(line, {}, path, r, 0, end, steps);
    RC_ASSERT(closed == never_touch ||
              std::abs(std::abs(cross(unit(b - a), path.position(closed) - a)) - r) < 1e-6);
    const double first = std::min(closed, searched);
    if (first == never_touch) return;
    const Closest closest = closest_point(line, path.position(first), r);
    // At an end of the face rounding decides; the end point is another feature.
    const double s = dot(path.position(first) - a, unit(b - a));
    if (std::min(std::abs(s), std::abs(s - length(b - a))) < 1e-6) return;
    // A ball that comes from past the end also hits that point.
    if (std::abs(closest.distance - r) > 1e-6) return;
    same(closed, searched, dot(path.velocity(first), closest.normal));
}

TEST(TimeOfImpact, ABallThatTurnsBelowALineDoesNotTouchIt) {
    const Feature line{Line{{-1, 1}, {1, 0}, 2, {}, {}}, 0, 0};
    for (const double rise : {0.3, 0.399, 0.401, 0.45}) {  // to the line: 0.4 m
        Path path;
        path.flight = {{0, 0.5}, {0.1, std::sqrt(2 * 9.81 * rise)}, {0, -9.81}, 0};
        EXPECT_EQ(time_of_impact(line, {}, path, 0.1, 0, 1, steps) == never_touch, rise < 0.4) << rise;
    }
}

// A ball passes another, which rests, on its surface; what its velocity has along the normal is rounding. It
// leaves the circle if gravity bends its path less than the circle is bent, else it touches at once. When
// each rounding was an impact, the two were in an island after twenty of them.
TEST(TimeOfImpact, ABallThatPassesAnotherOnItsSurfaceLeavesItOrTouchesAtOnce) {
    const double reach = 0.15, speed = 1.23, bend = speed * speed / reach;
    for (int k = 0; k < 1000; ++k) {
        const Vec2 normal = from_angle(0.1 + k), tangent = perp(normal);
        const double approach = (k % 7 - 3) * 1e-17;
        for (const double share : {0.0, 0.5, 0.95, 1.05, 2.0}) {
            Path still, passing;
            still.flight = {{-0.9418, 0.3}, {}, {}, 0};
            passing.flight = {still.flight.position + reach * normal, speed * tangent - approach * normal,
                              -share * bend * normal, 0};
            const double met = time_of_impact(passing, still, reach, 0, 0.05, steps);
            EXPECT_EQ(met, share < 1 ? never_touch : 0) << k << ", " << share;
        }
    }
}

// A ball on the surface, but past the end of a line by less than the clock resolves, would else have the same
// impact without end: handling it changes nothing.
TEST(TimeOfImpact, IsBetweenTheEndsOfALineAlsoWhereTheClockIsCoarse) {
    const Feature line{Line{{0, 0}, {1, 0}, 1, {}, {}}, 0, 0};
    const double r = 0.1, now = 0.75;
    Path path;
    path.start = now;
    path.flight = {{-3e-17, r}, {1, -0.1}, {}, 0};
    EXPECT_FALSE(closest_point(line, path.position(now), r).facing);
    const double met = search_impact(line, {}, path, r, now, 1, steps);
    EXPECT_GT(met, now);
    EXPECT_LT(met, now + 1e-12);
    EXPECT_TRUE(closest_point(line, path.position(met), r).facing);
}

// The first crossing, against an evaluation in small steps.
RC_GTEST_PROP(TimeOfImpact, FirstCrossingWithDragIsTheFirst, ()) {
    const double gap = between(-1, 1), rate = between(-3, 3), bend = between(-10, 10);
    const double drag = *rc::gen::element(1e-9, 0.05, 1.0, 20.0);
    const auto gap_at = [&](double t) {
        const TimeInterval s(drag, t);
        return gap + s.shrunk * rate + s.fallen * bend;
    };
    const double found = first_crossing(gap, rate, bend, drag);
    bool above = gap > 0;
    for (double t = 0; t < std::min(found, 3.0); t += 1e-3) {
        above = above || gap_at(t) > 0;
        RC_ASSERT(!above || gap_at(t) > -1e-12);
    }
    if (found > 3) return;
    RC_ASSERT(gap_at(found) < 1e-12 * (1 + std::abs(gap)));
    RC_ASSERT(gap_at(found + 1e-9) <= gap_at(found) + 1e-12);
}

RC_GTEST_PROP(TimeOfImpact, ClosedFormForACircleAgreesWithTheSearch, ()) {
    const Feature circle{Circle{anywhere(2), between(0, 0.5)}, 0, 0};
    const Path path = random_path({});
    const double r = between(0.01, 0.3);
    RC_PRE(closest_point(circle, path.flight.position, r).distance > r + 1e-6);
    const double closed = time_of_impact(circle, {}, path, r, 0, 1, steps);
    const double searched = search_impact(circle, {}, path, r, 0, 1, steps);
    const double first = std::min(closed, searched);
    if (first == never_touch) return;
    same(closed, searched, dot(path.velocity(first), closest_point(circle, path.position(first), r).normal));
}

RC_GTEST_PROP(TimeOfImpact, ClosedFormForBallsWithDragAgreesWithTheSearch, ()) {
    const Vec2 gravity = anywhere(10);
    Path a = random_path(gravity), b = random_path(gravity);
    a.flight.drag = b.flight.drag = between(0, 3);
    const double radii = between(0.02, 0.6);
    RC_PRE(length(a.flight.position - b.flight.position) > radii + 1e-6);
    const double closed = time_of_impact(a, b, radii, 0, 1, steps),
                 searched = search_impact(a, b, radii, 0, 1, steps);
    const double first = std::min(closed, searched);
    if (first == never_touch) return;
    same(closed, searched,
         dot(a.velocity(first) - b.velocity(first), unit(a.position(first) - b.position(first))));
}

// The search against an evaluation in small steps, on turning arcs and lines.
RC_GTEST_PROP(TimeOfImpact, SearchSkipsNoRoot, ()) {
    const double from = between(0, 6), to = from + between(0.2, 6);
    const Arc arc = arc_of({anywhere(0.5), between(0.4, 1), from, to});
    const Feature feature =
        *rc::gen::arbitrary<bool>() ? Feature{arc, 0, 0} : Feature{Line{{-1, 0.2}, {1, 0}, 2, {}, {}}, 0, 0};
    const double rate = *rc::gen::arbitrary<bool>() ? between(-30, 30) : 0;
    const Turning turning{{{0, 0}, between(0, 6)}, rate, INFINITY, 0};
    Path path = random_path(anywhere(10));
    path.flight.drag = *rc::gen::arbitrary<bool>() ? between(0, 5) : 0;
    const double r = between(0.02, 0.2), found = time_of_impact(feature, turning, path, r, 0, 0.5, steps);
    const auto gap_at = [&](double t) {
        const Closest closest = closest_point(feature, turning.pose(t).undo(path.position(t)), r);
        return closest.facing ? closest.distance - r : 1.0;
    };
    RC_PRE(gap_at(0) > 1e-3);
    double before = gap_at(0);
    for (double t = 0; t < std::min(found, 0.5); t += 1e-4) {
        const double gap = gap_at(t);
        // A ball that enters from past an end (a jump of the gap) hits the end point first.
        RC_ASSERT(gap > -1e-9 || before > 0.05 || before < -1e-9);
        before = gap;
    }
}

// A ball that rolls up the inside of a loop separates where gravity alone keeps it on the circle. Its
// distance grows as t³: |p|² − R² = −g·v·cos θ·t³ + g²·t⁴/4, so it hits the loop after t = 4·v·cos θ/g.
TEST(TimeOfImpact, ABallThatSeparatesFromALoopHitsItAgain) {
    constexpr double g = 9.81, loop = 0.3, radius = 0.05, reach = loop - radius;
    const Feature feature{arc_of({{0.2, -0.1}, loop, 0, 7}), 0, 0};
    for (const double angle : {0.1, 0.5, 1.0, 1.5}) {
        const double speed = std::sqrt(g * reach * std::sin(angle));
        Path path;
        path.flight = {
            Vec2{0.2, -0.1} + reach * from_angle(angle), speed * perp(from_angle(angle)), {0, -g}, 0};
        const double back = 4 * speed * std::cos(angle) / g;
        EXPECT_NEAR(time_of_impact(feature, {}, path, radius, 0, 1, steps), back, 1e-9) << angle;
    }
}

// A path that stays just above a line for a long time, with a large bound on its acceleration, and then
// crosses it: conservative steps alone would be millions.
TEST(TimeOfImpact, ASmallGapEndsInAnImpact) {
    constexpr double radius = 0.05, end = 1.0 / 60;
    const Feature floor{Line{{-1, 0}, {1, 0}, 2, {}, {}}, 0, 0};
    for (const double hair : {1e-9, 1e-11, 1e-13, 1e-15})
        for (const double down : {0.1 * end, 0.5 * end, 0.9 * end}) {
            Path path;
            path.flight.position = {0, radius + hair};
            TaylorPath& taylor = path.taylor.emplace_back();
            taylor.displacement[1] = {1, 0};
            taylor.displacement[2] = {0, -hair / (down * down)};
            taylor.top_speed = 1;
            taylor.top_acceleration = 1000;
            // Positions of half a decimetre are rounded to 1e-17.
            EXPECT_NEAR(time_of_impact(floor, {}, path, radius, 0, end, steps), down,
                        1e-9 + 2e-17 / hair * down)
                << hair << " " << down;
        }
}

// clear_of() is never true for a feature that the path touches.
RC_GTEST_PROP(TimeOfImpact, ClearFeaturesAreNotTouched, ()) {
    const double from = between(0, 6), to = from + between(0.2, 6);
    const Vec2 a = anywhere(0.5), b = anywhere(0.5);
    RC_PRE(length(b - a) > 0.01);
    const Feature feature = *rc::gen::element(Feature{arc_of({a, between(0.2, 1), from, to}), 0, 0},
                                              Feature{Line{a, unit(b - a), length(b - a), {}, {}}, 0, 0},
                                              Feature{Circle{a, between(0, 0.5)}, 0, 0});
    const Path path = random_path(anywhere(10));
    const double r = between(0.02, 0.2), end = between(0.01, 0.3);
    const double sag = path.max_acceleration(end) * end * end / 8;
    if (!clear_of(feature, path.position(0), path.position(end), r, sag)) return;
    for (double t = 0; t < end; t += 1e-3) {
        const Closest closest = closest_point(feature, path.position(t), r);
        RC_ASSERT(!closest.facing || closest.distance > r);
    }
}

// A step below rounding would never get anywhere.
TEST(ConservativeAdvancement, EndsWhereStepsAreRounding) {
    int steps_left = 10;
    const auto near_a_half = [](double t) { return t < 0.5 ? 0.5 : 1e-18; };
    EXPECT_EQ(conservative_advancement(near_a_half, 0, 1, steps_left), 0.5);
    EXPECT_EQ(steps_left, 8);
    EXPECT_EQ(conservative_advancement([](double) { return 0.3; }, 0, 1, steps_left), never_touch);
    EXPECT_EQ(steps_left, 4);
    EXPECT_EQ(conservative_advancement([](double) { return 0.01; }, 0, 1, steps_left), never_touch);
    EXPECT_LT(steps_left, 0);
}

}  // namespace
}  // namespace flipside::custom::test
