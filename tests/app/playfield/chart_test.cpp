#include "app/window/playfield/chart.hpp"

#include <set>

#include <gtest/gtest.h>

#include "app/window/playfield/inserts.hpp"
#include "app/window/playfield/nearest.hpp"
#include "lab/files/assets.hpp"
#include "world/scene_builder.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {
namespace {

Scene scene_named(const char* name) {
    return load_scene(lab::scene_file(name));
}

double depth_by_all(const Scene& scene, Vec2 place) {
    double depth = 1e9;
    for (const Primitive& primitive : surface_of(scene))
        if (is_coast(scene.parts[primitive.part]))
            depth = std::min(depth, length(place - nearest_of(primitive, place)));
    return depth;
}

TEST(Chart, SamplesAreTheDistanceToTheNearestStillPart) {
    const Scene scene = scene_named("pinball");
    const Chart chart = chart_of(scene);
    EXPECT_DOUBLE_EQ(chart.interval, scene.launcher->ball.radius);
    for (int row = 0; row < chart.rows; row += 7)
        for (int column = 0; column < chart.columns; column += 5) {
            const Vec2 place = chart.box.min + chart.spacing * Vec2{double(column), double(row)};
            const double most = (Chart::levels + 1) * chart.interval;
            const double depth = std::min(most, depth_by_all(scene, place));
            // Beyond the last line it is as good as deepest.
            if (depth < Chart::levels * chart.interval) {
                EXPECT_DOUBLE_EQ(chart.at(column, row), depth);
            }
        }
}

TEST(Chart, LinesLieWhereTheDepthIsAWholeNumberOfRadii) {
    for (const char* name : {"pinball", "toy", "bowl"}) {
        const Scene scene = scene_named(name);
        const Chart chart = chart_of(scene);
        std::size_t exact = 0;
        for (const Chart::Stroke& stroke : chart.strokes) {
            const double off = std::abs(depth_by_all(scene, stroke.a) - stroke.level * chart.interval);
            EXPECT_LT(off, chart.spacing) << name;
            if (off < 1e-9) ++exact;
            EXPECT_LT(length(stroke.b - stroke.a), 3 * chart.spacing) << name;
        }
        EXPECT_GT(chart.strokes.size(), 1000U) << name;
        EXPECT_GT(static_cast<double>(exact), 0.95 * static_cast<double>(chart.strokes.size())) << name;
    }
}

TEST(Chart, OfAWallHasLinesOfEveryLevelOnBothSides) {
    Scene scene = empty_scene({});
    scene.bounds = {{-1, -1}, {1, 1}};
    add_part(scene, {shape::Segment{{0, -1}, {0, 1}}}, {});
    const Chart chart = chart_of(scene);
    std::set<int> left, right;
    for (const Chart::Stroke& stroke : chart.strokes) (stroke.a.x < 0 ? left : right).insert(stroke.level);
    EXPECT_EQ(left.size(), static_cast<std::size_t>(Chart::levels));
    EXPECT_EQ(left, right);
}

TEST(Chart, OfNothingHasNoLines) {
    Scene scene = empty_scene({});
    scene.bounds = {{-1, -1}, {1, 1}};
    EXPECT_TRUE(chart_of(scene).strokes.empty());
}

TEST(Inserts, ThereIsOneForAllThatTheRulesName) {
    const Scene scene = scene_named("pinball");
    const Chart chart = chart_of(scene);
    std::size_t things = 5;  // the bonus twice to five times, and ball save
    for (const Rules::Group& group : scene.rules->lanes) things += group.parts.size();
    for (const Rules::Group& group : scene.rules->targets) things += group.parts.size() + 1;
    const std::vector<Insert> inserts = inserts_of(scene, chart);
    EXPECT_EQ(inserts.size(), things);
    for (const Insert& insert : inserts) {
        if (insert.kind == Insert::Kind::rollover) continue;
        EXPECT_GT(depth_by_all(scene, insert.at), insert.radius) << "a lamp lies under a part";
        EXPECT_TRUE(insert.kind != Insert::Kind::target || scene.parts[insert.of].target);
    }
    EXPECT_TRUE(inserts_of(scene_named("toy"), chart).empty());
}

}  // namespace
}  // namespace flipside::app
