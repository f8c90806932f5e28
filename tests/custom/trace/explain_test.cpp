#include "custom/trace/explain.hpp"

#include <random>

#include <gtest/gtest.h>

namespace flipside::custom {
namespace {

struct ExplainDice {
    std::mt19937_64 engine{14};
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(engine); }
    Vec2 place(double reach) { return {number(-reach, reach), number(-reach, reach)}; }
    Pose pose() { return {place(1), number(-3, 3)}; }
};

const primitive::Polygon triangle{{{-0.6, -0.3}, {0.7, -0.4}, {0.1, 0.5}}};

TEST(ExplainAxes, DecideAsTheNarrowPhaseDoes) {
    ExplainDice dice;
    int corners = 0, edges = 0;
    for (int k = 0; k < 10'000; ++k) {
        const Pose pose = dice.pose();
        const Vec2 center = pose.apply(dice.place(1.5));
        const double radius = dice.number(0.01, 0.8);
        const Touch found = touch(center, radius, Primitive{triangle, 0}, pose);
        TraceStage stage;
        explain_axes(stage, {}, center, radius, triangle, pose);
        const auto& axes = stage.items;
        const auto is_true = [](const TraceItem& axis) { return axis.get<bool>("decides"); };
        const auto decides = std::ranges::find_if(axes, is_true);
        ASSERT_NE(decides, axes.end());
        EXPECT_EQ(std::ranges::count_if(axes, is_true), 1);
        const double least = decides->get<double>("depth");
        EXPECT_NEAR(least, -found.separation, 1e-12);
        EXPECT_LT(length(decides->get<Vec2>("axis") - found.normal), 1e-9);
        for (const TraceItem& item : axes) {
            const Vec2 axis = item.get<Vec2>("axis");
            const auto& polygon = item.get<std::vector<double>>("shadow_of_part");
            const auto& disc = item.get<std::vector<double>>("shadow_of_ball");
            EXPECT_GE(item.get<double>("depth"), least - 1e-12);
            EXPECT_NEAR(disc[1] - disc[0], 2 * radius, 1e-12);
            double low = INFINITY, high = -INFINITY;
            for (const Vec2 corner : triangle.points) {
                low = std::min(low, dot(pose.apply(corner), axis));
                high = std::max(high, dot(pose.apply(corner), axis));
            }
            EXPECT_NEAR(polygon[0], low, 1e-12);
            EXPECT_NEAR(polygon[1], high, 1e-12);
            EXPECT_NEAR(disc[0], dot(center, axis) - radius, 1e-12);
        }
        ++(axes.size() == 4 ? corners : edges);
    }
    EXPECT_GT(corners, 1000);
    EXPECT_GT(edges, 1000);
}

TraceItem explained(Vec2 center, const Primitive& primitive, const Pose& pose) {
    TraceItem item;
    explain_touch(item, center, 0.1, primitive, pose);
    return item;
}

/// The closest point follows from the fields of the item.
TEST(ExplainTouch, TheClampedPlaceIsTheClosestPoint) {
    ExplainDice dice;
    const Primitive segment{primitive::Segment{{-0.5, 0.1}, {0.6, 0.3}}, 0};
    const Primitive arc{primitive::Arc{{0.1, 0}, 0.5, 0.4, 5.1}, 0};
    const Primitive polygon{triangle, 0};
    for (int k = 0; k < 3000; ++k) {
        const Pose pose = dice.pose();
        const Vec2 center = pose.apply(dice.place(1.5));
        for (const Primitive* straight : {&segment, &polygon}) {
            const TraceItem item = explained(center, *straight, pose);
            const Touch found = touch(center, 0.1, *straight, pose);
            const Vec2 a = item.get<Vec2>("a"), b = item.get<Vec2>("b");
            EXPECT_LT(length(a + item.get<double>("along") * (b - a) - item.get<Vec2>("foot")), 1e-12);
            if (straight == &segment || found.separation > -0.1) {
                EXPECT_LT(length(a + item.get<double>("clamped") * (b - a) - found.point), 1e-12);
            }
        }
        const TraceItem item = explained(center, arc, pose);
        const double from = item.get<double>("from"), to = item.get<double>("to");
        const Vec2 at =
            item.get<Vec2>("middle") +
            item.get<double>("core") * from_angle(from + item.get<double>("clamped") * (to - from));
        EXPECT_LT(length(at - touch(center, 0.1, arc, pose).point), 1e-9);
    }
}

TEST(ExplainTouch, OfATaperTellsWhichPartOfItIsNearest) {
    const Primitive taper{primitive::Taper{{0, 0}, {1, 0}, 0.3, 0.1}, 0};
    EXPECT_LT(explained({-1, 0.1}, taper, {}).get<double>("along"), 0);
    EXPECT_GT(explained({2, 0.1}, taper, {}).get<double>("along"), 1);
    // Straight out from the middle of the side, which leans by asin(0.2).
    const double lean = std::asin(0.2);
    const Vec2 normal{std::sin(lean), std::cos(lean)};
    const TraceItem item = explained(Vec2{0.5, 0} + 0.7 * normal, taper, {});
    EXPECT_NEAR(item.get<double>("along"), 0.5, 1e-12);
    EXPECT_EQ(item.get<std::string>("feature"), "a straight side");
}

}  // namespace
}  // namespace flipside::custom
