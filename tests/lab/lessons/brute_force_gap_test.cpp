#include "lab/lessons/brute_force_gap.hpp"

#include <gtest/gtest.h>

namespace flipside::lab {
namespace {

constexpr int points = 10'000;

TEST(BruteForceGap, FindsDistancesThatAreKnown) {
    const auto from = [](Vec2 center, const auto& kind) {
        return distance_by_brute_force(center, Primitive{kind, 0}, points);
    };
    EXPECT_EQ(from({3, 4}, primitive::Point{{0, 0}}), 5);
    const primitive::Segment segment{{-1, 0}, {1, 0}};
    EXPECT_NEAR(from({0.1234567, 0.5}, segment), 0.5, 1e-8);
    EXPECT_EQ(from({2, 0}, segment), 1);
    const primitive::Arc half{{0, 0}, 1, 0, 3.14159265358979};
    EXPECT_NEAR(from({0.3, 1.2}, half), length(Vec2{0.3, 1.2}) - 1, 1e-7);
    EXPECT_NEAR(from({0.5, -1}, half), length(Vec2{0.5, 1}), 1e-12);  // an end
    EXPECT_NEAR(from({0, 0.25}, primitive::Circle{{0, 0}, 1}), 0.75, 1e-7);
    const primitive::Polygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    EXPECT_NEAR(from({0.5, 0.3}, square), 0.3, 1e-7);
    EXPECT_NEAR(from({2, 2}, square), length(Vec2{1, 1}), 1e-12);
    const primitive::Taper capsule{{0, 0}, {1, 0}, 0.2, 0.2};
    EXPECT_NEAR(from({0.4, 0.5}, capsule), 0.3, 1e-7);
    EXPECT_NEAR(from({-1, 0}, capsule), 0.8, 1e-7);
    EXPECT_NEAR(from({0.5, 0}, capsule), 0.2, 1e-7);  // from within
    const primitive::Taper flipper{{0, 0}, {1, 0}, 0.3, 0.1};
    const Vec2 normal = from_angle(std::acos(0.2));
    EXPECT_NEAR(from(Vec2{0.5, 0} + 0.6 * normal, flipper), 0.6 - 0.2, 1e-7);
    EXPECT_NEAR(from({1.5, 0}, flipper), 0.4, 3e-7);  // the nearest point lies between two
}

TEST(BruteForceGap, OfAWrongTraceTellsHowWrong) {
    Scene scene;
    Part part;
    part.name = "wall";
    part.shape.is = shape::Segment{{-1, 0}, {1, 0}};
    scene.parts.push_back(part);
    Trace trace;
    TraceStage& stage = trace.stage("narrow phase", "here");
    EXPECT_EQ(separation_off(trace, scene), 0);
    const std::vector<Primitive> primitives = surface_of(scene);
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (std::holds_alternative<primitive::Segment>(primitives[i].is))
            stage.add("closest")
                .with("primitive", i)
                .with("pivot", Vec2{})
                .with("pose_angle", 0.0)
                .with("center", Vec2{0.2, 0.5})
                .with("radius", 0.1)
                .with("separation", 0.4 + 0.003);
    EXPECT_NEAR(separation_off(trace, scene), 0.003, 1e-6);
}

}  // namespace
}  // namespace flipside::lab
