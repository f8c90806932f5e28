#include "custom/continuous/feature.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "custom/between.hpp"
#include "custom/continuous/arc.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

using std::numbers::pi;

/// Whether a short way through `at`, in a direction that is `turned` from `normal`, crosses the feature.
bool crossed_at(const Feature& feature, Vec2 at, Vec2 normal, double turned) {
    const Vec2 way = 1e-3 * rotated(normal, turned);
    return crosses(feature, at - between(0.1, 1) * way, at + between(0.1, 1) * way);
}

RC_GTEST_PROP(Crosses, ALineBetweenItsEndsOnly, ()) {
    const Vec2 along = from_angle(between(0, 2 * pi)), start{between(-1, 1), between(-1, 1)};
    const double length = between(0.5, 2), share = between(-1, 2), turned = between(-1.3, 1.3);
    RC_PRE(std::abs(share) > 0.02 && std::abs(share - 1) > 0.02);
    const Feature line{Line{start, along, length, {}, {}}};
    const Vec2 at = start + share * length * along;
    RC_ASSERT(crossed_at(line, at, perp(along), turned) == (share > 0 && share < 1));
    // Beside it, or along it at a distance.
    RC_ASSERT(!crosses(line, at + 0.1 * perp(along), at + 0.2 * perp(along)));
    RC_ASSERT(!crosses(line, start + 1e-3 * perp(along), start + length * along + 1e-3 * perp(along)));
}

RC_GTEST_PROP(Crosses, AnArcBetweenItsEndsOnly, ()) {
    const double from = between(0, 2 * pi), angle = between(0.3, 6), radius = between(0.2, 2);
    const double share = between(-0.5, 1.5), turned = between(-1.3, 1.3);
    const primitive::Arc arc{{between(-1, 1), between(-1, 1)}, radius, from, from + angle};
    const double at = from + share * angle, beside = 0.02;
    const auto is_on = [&](double off) {
        const double turns = std::remainder(at + off - from - angle / 2, 2 * pi);
        return std::abs(turns) < angle / 2;
    };
    RC_PRE(is_on(beside) == is_on(-beside));
    const Vec2 out = from_angle(at);
    RC_ASSERT(crossed_at(Feature{arc_of(arc)}, arc.center + radius * out, out, turned) == is_on(0));
}

RC_GTEST_PROP(Crosses, ACircleButNotAPoint, ()) {
    const Vec2 center{between(-1, 1), between(-1, 1)}, out = from_angle(between(0, 2 * pi));
    const double radius = between(0.1, 1);
    RC_ASSERT(crossed_at(Feature{Circle{center, radius}}, center + radius * out, out, between(-1.3, 1.3)));
    RC_ASSERT(!crosses(Feature{Circle{center, radius}}, center, center + 0.9 * radius * out));
    RC_ASSERT(crosses(Feature{Circle{center, radius}}, center - 2 * radius * out, center + 2 * radius * out));
    RC_ASSERT(!crosses(Feature{Circle{center, 0}}, center - perp(out) - out, center - perp(out) + out));
}

}  // namespace
}  // namespace flipside::custom::test
