#include "world/surface.hpp"

#include <algorithm>

#include "world/support.hpp"

namespace flipside {
namespace {

std::vector<Primitive> surface(const std::string& parts) {
    return surface_of(parse_scene(
        R"({"format": "flipside-scene/1", "bounds": {"min": [-9, -9], "max": [9, 9]}, "parts": [)" + parts +
            "]}",
        "s.json"));
}

/// Where the point primitives are, by x then y.
std::vector<Vec2> points(const std::vector<Primitive>& primitives) {
    std::vector<Vec2> found;
    for (const Primitive& primitive : primitives)
        if (const auto* point = std::get_if<primitive::Point>(&primitive.is)) found.push_back(point->at);
    std::ranges::sort(found, [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return found;
}

std::string segment(const std::string& name, const std::string& a, const std::string& b,
                    const std::string& more = "") {
    return R"({"name": ")" + name + R"(", "shape": {"type": "segment", "a": )" + a + R"(, "b": )" + b + "}" +
           more + "}";
}

TEST(Surface, FreeEndsArePoints) {
    const auto primitives = surface(segment("s", "[0, 0]", "[1, 0]"));
    EXPECT_EQ(primitives.size(), 3U);
    EXPECT_EQ(points(primitives), (std::vector<Vec2>{{0, 0}, {1, 0}}));
}

TEST(Surface, SmoothJointOfTwoPartsHasNoPoint) {
    // A segment that goes on as an arc: the tangents agree at (1, 0).
    const auto primitives = surface(segment("s", "[0, 0]", "[1, 0]") +
                                    R"(, {"name": "a", "shape": {"type": "arc", "center": [1, 1], "radius": 1,
                                      "from_deg": -90, "to_deg": 90}})");
    const auto found = points(primitives);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], (Vec2{0, 0}));
    EXPECT_NEAR(length(found[1] - Vec2{1, 2}), 0, 1e-15);
}

TEST(Surface, CornerIsOnePoint) {
    EXPECT_EQ(points(surface(segment("s", "[0, 0]", "[1, 0]") + "," + segment("t", "[1, 0]", "[1, 1]"))),
              (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}}));
}

TEST(Surface, FoldedBackIsNoSmoothJoint) {
    EXPECT_EQ(
        points(surface(segment("s", "[0, 0]", "[1, 0]") + "," + segment("t", "[1, 0]", "[0.5, 0]"))).size(),
        3U);
}

TEST(Surface, ThreeCurvesAtOneJoint) {
    const std::string straight = segment("a", "[0, 0]", "[1, 0]") + "," + segment("b", "[1, 0]", "[2, 0]");
    // A third one that ends on a smooth joint adds only its free end, in whatever order they come.
    const std::string third = segment("c", "[1, 0]", "[1, 1]");
    const std::vector<Vec2> free_ends = {{0, 0}, {1, 1}, {2, 0}};
    EXPECT_EQ(points(surface(straight + "," + third)), free_ends);
    EXPECT_EQ(points(surface(third + "," + straight)), free_ends);
    // Without two that agree, the joint is one corner.
    const std::string star =
        segment("a", "[0, 0]", "[1, 0]") + "," + segment("b", "[1, 0]", "[2, 1]") + "," + third;
    EXPECT_EQ(points(surface(star)), (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {2, 1}}));
}

TEST(Surface, PartsThatMoveVanishOrLieOnAnotherLayerKeepTheirEnds) {
    const std::string still = segment("s", "[0, 0]", "[1, 0]") + ",";
    for (const char* more : {R"(, "motion": {"type": "turn", "pivot": [2, 0], "rate": 1})",
                             R"(, "target": true)", R"(, "sensor": true)", R"(, "layer": "attic")"})
        EXPECT_EQ(points(surface(still + segment("t", "[1, 0]", "[2, 0]", more))).size(), 4U) << more;
}

TEST(Surface, ClosedPolylineHasAPointPerCornerAndNoneOnAStraightOne) {
    const auto primitives = surface(R"({"name": "p", "shape": {"type": "polyline", "closed": true,
                                    "points": [[0, 0], [1, 0], [2, 0], [2, 2], [0, 2]]}})");
    EXPECT_EQ(points(primitives), (std::vector<Vec2>{{0, 0}, {0, 2}, {2, 0}, {2, 2}}));
    EXPECT_EQ(primitives.size(), 5U + 4U);
}

TEST(Surface, FullCircleArcHasNoEnds) {
    EXPECT_EQ(surface(R"({"name": "a", "shape": {"type": "arc", "center": [0, 0], "radius": 1, "from_deg": 33,
                          "to_deg": 393}})")
                  .size(),
              1U);
}

TEST(Surface, GateHasTwoEndsThatJoinNothing) {
    const auto primitives =
        surface(R"({"name": "g", "shape": {"type": "gate", "a": [0, 0], "b": [1, 0], "normal": [0, 1]}},
                                   {"name": "s", "shape": {"type": "segment", "a": [1, 0], "b": [2, 0]}})");
    EXPECT_EQ(points(primitives), (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 0}, {2, 0}}));
    EXPECT_EQ(primitives.size(), 2U + 4U);
}

TEST(Surface, PrimitivesComeByPartAndSolidsAreOnePrimitive) {
    const Scene scene = scene_with_everything();
    const auto primitives = surface_of(scene);
    EXPECT_TRUE(std::ranges::is_sorted(primitives, {}, &Primitive::part));
    const auto bat = std::ranges::find(primitives, PartIndex{1}, &Primitive::part);
    ASSERT_NE(bat, primitives.end());
    const auto& taper = std::get<primitive::Taper>(bat->is);
    EXPECT_EQ(taper.radius_a, 0.02);
    EXPECT_EQ(taper.radius_b, 0.01);
    // 0.1 m from the pivot (0.5, 0) at −30°.
    EXPECT_NEAR(length(taper.b - Vec2{0.5 + 0.1 * std::sqrt(0.75), -0.05}), 0, 1e-15);
    EXPECT_EQ(gate_of(scene.parts[0]), nullptr);
    ASSERT_NE(gate_of(scene.parts[3]), nullptr);
}

}  // namespace
}  // namespace flipside
