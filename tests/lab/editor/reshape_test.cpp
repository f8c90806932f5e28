#include "lab/editor/reshape.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lab/editor/handles.hpp"
#include "lab/editor/palette.hpp"
#include "lab/session/pick.hpp"
#include "world/scene_file.hpp"
#include "world/surface.hpp"

namespace flipside::lab {
namespace {

constexpr double pi = std::numbers::pi;

/// A whole number of tenths of a millimetre within a metre.
Vec2 any_place() {
    return {*rc::gen::inRange(-5000, 5000) * 1e-4, *rc::gen::inRange(-5000, 5000) * 1e-4};
}

std::vector<const Tool*> part_tools() {
    std::vector<const Tool*> parts;
    for (const Tool& tool : tools())
        if (place_of(tool) == "parts" && tool.name != "Select") parts.push_back(&tool);
    return parts;
}

/// A part of any kind that is drawn by a hand.
OrderedJson any_part() {
    const Tool& tool = **rc::gen::elementOf(part_tools());
    std::vector<Vec2> points{any_place()};
    if (tool.name == "Polygon")
        for (int i = 1; i < 5; ++i) points.push_back(points[0] + 0.1 * (from_angle(i * 1.2) - Vec2{1, 0}));
    else if (tool.points != 1)
        for (int i = tool.points == 2 ? 1 : 3; i > 0; --i) {
            points.push_back(any_place());
            RC_PRE(length(points.back() - points[points.size() - 2]) > 1e-2);
        }
    return made(tool, points, "it", 0.0135);
}

Scene scene_with(const OrderedJson& part) {
    OrderedJson document = OrderedJson::parse(new_scene());
    document["bounds"] = {{"min", {-50, -50}}, {"max", {50, 50}}};
    document["parts"].push_back(part);
    return parse_scene(document.dump(), "drawn");
}

RC_GTEST_PROP(ReshapeProperty, WhatIsDrawnIsAGoodSceneAndLooksAsItIs, ()) {
    const OrderedJson part = any_part();
    const Scene good = scene_with(part);
    const Scene sketch = sketch_of({{"parts", {part}}});
    // The sketch has the surface of the scene that is run.
    RC_ASSERT(surface_of(sketch).size() == surface_of(good).size());
    const std::vector<PartState> still(1);
    const Box drawn = extent_of(sketch, still, 0), run = extent_of(good, still, 0);
    RC_ASSERT(length(drawn.min - run.min) + length(drawn.max - run.max) < 1e-9);
}

RC_GTEST_PROP(ReshapeProperty, WhatIsMovedLiesThere, ()) {
    const OrderedJson part = any_part();
    const Vec2 by = any_place();
    const std::vector<PartState> still(1);
    const Box before = extent_of(scene_with(part), still, 0),
              after = extent_of(scene_with(moved(part, by)), still, 0);
    RC_ASSERT(length(after.min - before.min - by) + length(after.max - before.max - by) < 1e-8);
    // There and back again.
    RC_ASSERT(moved(moved(part, by), -by) == moved(part, {}));
}

RC_GTEST_PROP(ReshapeProperty, WhatIsTurnedKeepsItsDistances, ()) {
    const OrderedJson part = any_part();
    const Vec2 about = any_place();
    const double angle = *rc::gen::inRange(-700, 700) * 0.01;
    const OrderedJson after = turned(part, about, angle);
    static_cast<void>(scene_with(after));
    const std::vector<Handle> was = handles_of(part), is = handles_of(after);
    RC_ASSERT(was.size() == is.size());
    for (std::size_t i = 0; i < was.size(); ++i) {
        if (was[i].role == Role::radius) continue;  // it stays on the right
        RC_ASSERT(length(about + rotated(was[i].at - about, angle) - is[i].at) < 1e-7);
    }
}

RC_GTEST_PROP(ReshapeProperty, AHandleComesToWhereItIsPulled, ()) {
    const OrderedJson part = any_part();
    const std::vector<Handle> handles = handles_of(part);
    const Handle handle = *rc::gen::elementOf(handles);
    const Vec2 to = handle.at + Vec2{*rc::gen::inRange(1, 50) * 1e-3, *rc::gen::inRange(1, 50) * 1e-3};
    const OrderedJson after = pulled(part, handle, to);
    switch (handle.role) {
        case Role::corner:
        case Role::centre:
        case Role::arc_end:
        case Role::tip:
            for (const Handle& now : handles_of(after))
                if (now.is(handle.role, handle.index)) RC_ASSERT(length(now.at - to) < 1e-6);
            break;
        case Role::between: {
            const OrderedJson& points = after.at("shape").at("points");
            RC_ASSERT(points.size() == part.at("shape").at("points").size() + 1);
            RC_ASSERT(length(vector_of(points.at(handle.index + 1)) - to) < 1e-9);
            // And it can be taken away again.
            RC_ASSERT(without_corner(after, handle.index + 1) == part);
            break;
        }
        default:
            break;
    }
}

RC_GTEST_PROP(ReshapeProperty, TheOtherEndAndTheAngleOfAnArcStay, ()) {
    const Tool& arc = tools()[3];
    RC_ASSERT(arc.name == "Arc");
    const Vec2 points[] = {any_place(), any_place()}, to = any_place();
    RC_PRE(length(points[1] - points[0]) > 1e-2);
    RC_PRE(length(to - points[1]) > 1e-2);
    const OrderedJson part = made(arc, points, "it", 0.01);
    for (const Handle& handle : handles_of(part)) {
        if (!handle.is(Role::arc_end, 0)) continue;
        const OrderedJson after = pulled(part, handle, to);
        const std::vector<Vec2> ends = joints_of(after);
        RC_ASSERT(length(ends[0] - to) < 1e-6);
        RC_ASSERT(length(ends[1] - points[1]) < 1e-6);
        const OrderedJson& shape = after.at("shape");
        RC_ASSERT(std::abs(shape.at("to_deg").get<double>() - shape.at("from_deg").get<double>() - 90) <
                  1e-6);
    }
}

TEST(Reshape, TheBulgeOfAnArcKeepsItsEnds) {
    const OrderedJson arc = OrderedJson::parse(
        R"({"shape": {"type": "arc", "center": [0, 0], "radius": 1, "from_deg": 0, "to_deg": 90}})");
    const Handle middle{Role::arc_bulge, 0, from_angle(pi / 4)};
    // The half circle over that chord.
    const Vec2 chord_middle{0.5, 0.5};
    const OrderedJson half = pulled(arc, middle, chord_middle + std::sqrt(0.5) * from_angle(pi / 4));
    EXPECT_NEAR(half.at("shape").at("radius").get<double>(), std::sqrt(0.5), 1e-8);
    EXPECT_NEAR(half.at("shape").at("to_deg").get<double>() - half.at("shape").at("from_deg").get<double>(),
                180, 1e-6);
    const OrderedJson inward = pulled(arc, middle, {0.4, 0.4});
    EXPECT_LT(length(joints_of(inward)[0] - Vec2{0, 1}), 1e-6) << "its ends change places";
    EXPECT_LT(length(joints_of(inward)[1] - Vec2{1, 0}), 1e-6);
    const OrderedJson rounded = with_whole_sweep(pulled(arc, middle, {0.75, 0.73}), middle, 15);
    const OrderedJson& shape = rounded.at("shape");
    const double steps = (shape.at("to_deg").get<double>() - shape.at("from_deg").get<double>()) / 15;
    EXPECT_NEAR(steps, std::round(steps), 1e-6);
    const std::vector<Vec2> ends = joints_of(rounded);
    EXPECT_LT(length(ends[0] - Vec2{1, 0}) + length(ends[1] - Vec2{0, 1}), 1e-6);
}

TEST(Reshape, AFlippersRaiseTurnsWithIt) {
    const Tool& flipper = tools()[8];
    ASSERT_EQ(flipper.name, "Flipper");
    const Vec2 points[] = {{0.1, 0.1}, {0.17, 0.08}};
    const OrderedJson part = made(flipper, points, "it", 0.0135);
    EXPECT_EQ(part.at("motion").at("side"), "left");
    const OrderedJson after = turned(part, {0, 0}, pi);
    const auto way = [](const OrderedJson& p) {
        return p.at("motion").at("raised_deg").get<double>() - p.at("shape").at("rest_deg").get<double>();
    };
    EXPECT_NEAR(way(after), way(part), 1e-9);
}

TEST(Reshape, EndsThatLieTogetherInACompoundMoveTogether) {
    const OrderedJson guide = OrderedJson::parse(R"({"name": "guide", "shape": {"type": "compound", "of": [
        {"type": "segment", "a": [0, 0], "b": [0, 1]},
        {"type": "arc", "center": [1, 1], "radius": 1, "from_deg": 90, "to_deg": 180},
        {"type": "circle", "center": [0, 0], "radius": 0.1}]}})");
    const std::vector<Handle> handles = handles_of(guide);
    const auto joint = std::ranges::find_if(handles, [](const Handle& handle) {
        return handle.role == Role::corner && length(handle.at - Vec2{0, 1}) < 1e-9;
    });
    ASSERT_NE(joint, handles.end());
    EXPECT_EQ(
        std::ranges::count_if(handles, [&](const Handle& h) { return length(h.at - joint->at) < 1e-9; }), 1);
    const OrderedJson after = pulled(guide, *joint, {0.1, 0.8});
    const OrderedJson& members = after.at("shape").at("of");
    EXPECT_EQ(vector_of(members[0].at("b")), (Vec2{0.1, 0.8}));
    EXPECT_LT(length(joints_of(members[1])[1] - Vec2{0.1, 0.8}), 1e-6);
    EXPECT_LT(length(joints_of(members[1])[0] - Vec2{1, 2}), 1e-6);
    EXPECT_EQ(members[2], guide.at("shape").at("of")[2]);
}

TEST(Reshape, KeysThatItDoesNotKnowStay) {
    const OrderedJson part = OrderedJson::parse(
        R"({"later": {"x": [1, 2]}, "name": "n", "shape": {"type": "segment", "a": [0, 0], "b": [1, 0]}})");
    EXPECT_EQ(moved(part, {1, 2}).at("later"), part.at("later"));
    EXPECT_EQ(turned(part, {1, 2}, 3).at("later"), part.at("later"));
}

}  // namespace
}  // namespace flipside::lab
