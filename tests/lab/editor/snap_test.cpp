#include "lab/editor/snap.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace flipside::lab {
namespace {

const SnapRules rules{true, 0.01, 0.004};

Vec2 any_point() {
    return {*rc::gen::inRange(-100000, 100000) * 1e-5, *rc::gen::inRange(-100000, 100000) * 1e-5};
}

TEST(Snap, AnEndWithinReachComesBeforeTheGrid) {
    const Vec2 ends[] = {{0.1234, 0.5}, {0.3, 0.3}};
    const Snapped to = snap({0.1256, 0.5021}, ends, Vec2{0, 0}, rules);
    EXPECT_EQ(to.at, ends[0]);
    EXPECT_EQ(to.to, SnappedTo::end);
    EXPECT_EQ(snap({0.1289, 0.5}, ends, {}, rules).at, (Vec2{0.13, 0.5}));
}

TEST(Snap, AnglesAreMultiplesOf15Degrees) {
    const Vec2 at = rotated({0.2, 0}, std::numbers::pi / 6) + Vec2{0.0002, -0.0001};
    const Snapped to = snap(at, {}, Vec2{0, 0}, rules);
    EXPECT_EQ(to.to, SnappedTo::angle);
    EXPECT_NEAR(angle_of(to.at), std::numbers::pi / 6, 1e-12);
    EXPECT_NEAR(length(to.at), 0.2, 1e-12);
}

TEST(Snap, GridPointsAreShortDecimals) {
    EXPECT_EQ(snap({0.3004, 0.6999}, {}, {}, rules).at, (Vec2{0.3, 0.7}));
    EXPECT_EQ(snap({0.0351, -0.0001}, {}, {}, {true, 0.005, 0.001}).at, (Vec2{0.035, 0}));
}

TEST(Snap, ThePitchSuitsTheTable) {
    EXPECT_EQ(usual_pitch(0.52), 0.01);
    EXPECT_EQ(usual_pitch(0.1), 0.001);
    EXPECT_EQ(usual_pitch(1e9), 10);
}

RC_GTEST_PROP(SnapProperty, GoesNoFartherThanAGridsDiagonalAndStaysThere, ()) {
    const Vec2 point = any_point();
    const Snapped once = snap(point, {}, {}, rules);
    RC_ASSERT(length(once.at - point) <= 0.5 * std::sqrt(2) * rules.pitch + 1e-12);
    RC_ASSERT(snap(once.at, {}, {}, rules).at == once.at);
}

RC_GTEST_PROP(SnapProperty, WithAnAnchorItIsOnTheGridOrInSuchADirectionAndNoFarther, ()) {
    const Vec2 point = any_point(), anchor = any_point();
    const Snapped to = snap(point, {}, anchor, rules);
    RC_ASSERT(length(to.at - point) <= 0.5 * std::sqrt(2) * rules.pitch + 1e-12);
    if (to.to == SnappedTo::angle) {
        const double turns = angle_of(to.at - anchor) / (snap_degrees * std::numbers::pi / 180);
        RC_ASSERT(std::abs(turns - std::round(turns)) < 1e-6);
    } else {
        RC_ASSERT(to.at == snap(point, {}, {}, rules).at);
    }
}

RC_GTEST_PROP(SnapProperty, TheNearestEndIsTaken, ()) {
    const Vec2 point = any_point();
    std::vector<Vec2> ends;
    for (int i = *rc::gen::inRange(1, 5); i > 0; --i)
        ends.push_back(point + Vec2{*rc::gen::inRange(-60, 60) * 1e-4, *rc::gen::inRange(-60, 60) * 1e-4});
    const Snapped to = snap(point, ends, {}, rules);
    const bool near =
        std::any_of(ends.begin(), ends.end(), [&](Vec2 end) { return length(end - point) <= rules.reach; });
    RC_ASSERT((to.to == SnappedTo::end) == near);
    for (const Vec2 end : ends) RC_ASSERT(!near || length(to.at - point) <= length(end - point));
}

RC_GTEST_PROP(SnapProperty, AMoveJoinsEndsToTheBit, ()) {
    const Vec2 from = any_point(), other = any_point();
    const Vec2 off{*rc::gen::inRange(-25, 25) * 1e-4, *rc::gen::inRange(-25, 25) * 1e-4};
    const Vec2 own[] = {from}, ends[] = {other};
    RC_ASSERT(length(from + snap_move(other - from + off, own, ends, rules) - other) < 1e-12);
}

RC_GTEST_PROP(SnapProperty, SuspendedItOnlyRounds, ()) {
    const Vec2 point = any_point(), ends[] = {any_point()};
    const Snapped to = snap(point + Vec2{3e-6, 0}, ends, any_point(), {false, 0.01, 0.004});
    RC_ASSERT(to.to == SnappedTo::nothing);
    RC_ASSERT(length(to.at - point) < 1e-5);
}

}  // namespace
}  // namespace flipside::lab
