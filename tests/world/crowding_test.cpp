#include "world/crowding.hpp"

#include <ctime>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "world/support.hpp"

namespace flipside {
namespace {

bool overlap(const Boxed& a, const Boxed& b) {
    const bool boxes = a.box.min.x <= b.box.max.x && b.box.min.x <= a.box.max.x &&
                       a.box.min.y <= b.box.max.y && b.box.min.y <= a.box.max.y;
    return boxes && ((!a.is_ball && !b.is_ball) || layers_meet(a, b));
}

// The sweep finds exactly as many pairs as a look at each: one fewer is too few to allow, as many are enough.
// Up to seven kinds of things are told apart.
RC_GTEST_PROP(Crowding, CountsTheOverlappingPairs, ()) {
    std::vector<Boxed> things;
    const int n = *rc::gen::inRange(2, 60);
    for (int i = 0; i < n; ++i) {
        // Whole numbers, so that many boxes share a border or have no width.
        const auto whole = [](int most) { return static_cast<double>(*rc::gen::inRange(0, most)); };
        const Vec2 low{whole(20), whole(20)};
        const Box box{low, low + Vec2{whole(6), whole(6)}};
        const std::vector<Boxed> kinds{{box, true, 1, 3}, {box, true, 1, 1}, {box, true, 1, 2},
                                       {box, true, 2, 1}, {box, true, 2, 3}, {box, false, 1, 3},
                                       {box, false, 2, 2}};
        things.push_back(kinds[*rc::gen::inRange<std::size_t>(0, kinds.size())]);
    }
    std::uint64_t pairs = 0;
    for (std::size_t i = 0; i < things.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) pairs += overlap(things[i], things[j]) ? 1U : 0U;
    RC_ASSERT(!crowded_at(things, pairs));
    if (pairs > 0) RC_ASSERT(crowded_at(things, pairs - 1).has_value());
}

std::string scene_of(const std::string& balls, const std::string& parts) {
    return R"({"format": "flipside-scene/1", "name": "crowd", "bounds": {"min": [-1, -1], "max": [1, 1]},)"
           R"("balls": [)" +
           balls + R"(], "parts": [)" + parts + "]}";
}

std::string times(int n, auto&& text) {
    std::string all;
    for (int i = 0; i < n; ++i) all += (i == 0 ? "" : ",") + text(i);
    return all;
}

// Three thousand balls at one place, or ten thousand circles, are refused before any engine sees them.
TEST(Crowding, OfASceneIsRefusedWithItsLimit) {
    const auto ball = [](int) { return std::string(R"({"position": [0, 0], "radius": 0.1, "mass": 1})"); };
    expect_error(error_of([&] { (void)parse_scene(scene_of(times(3000, ball), ""), "crowd.json"); }),
                 "crowd.json: too much lies over one another, as where ball ",
                 "allowed are 442000 overlapping pairs");
    const auto circle = [](int i) {
        return R"({"name": "c)" + std::to_string(i) +
               R"(", "shape": {"type": "circle", "center": [0, 0], "radius": 0.1}})";
    };
    expect_error(error_of([&] { (void)parse_scene(scene_of("", times(10'000, circle)), "crowd.json"); }),
                 "crowd.json: too much lies over one another, as where part \"c",
                 "allowed are 890000 overlapping pairs");
    EXPECT_EQ(parse_scene(scene_of(times(600, ball), ""), "crowd.json").balls.size(), 600U);
}

// Balls that pass through each other may be as many at one place as there are.
TEST(Crowding, OfBallsThatDoNotMeetIsNone) {
    const auto ghost = [](int) {
        return std::string(R"({"position": [0, 0], "radius": 0.1, "mass": 1, "collides_with": []})");
    };
    EXPECT_EQ(parse_scene(scene_of(times(3000, ghost), ""), "crowd.json").balls.size(), 3000U);
}

TEST(Crowding, OfAMillionBoxesIsFoundInSeconds) {
    std::vector<Boxed> things;
    for (int i = 0; i < 1'000'000; ++i) {
        const Vec2 low{static_cast<double>(i % 1000), static_cast<double>(i / 1000)};
        things.push_back({{low, low + Vec2{0.9, 0.9}}, true, 1, 1});
    }
    const std::clock_t began = std::clock();
    EXPECT_FALSE(crowded_at(things, 0));
    EXPECT_LT(static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, 60);
}

}  // namespace
}  // namespace flipside
