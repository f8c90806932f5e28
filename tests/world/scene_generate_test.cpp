// Generated rows and fields.

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "places.hpp"
#include "world/support.hpp"

namespace flipside {
namespace {

const std::string field_text =
    R"({"format": "flipside-scene/1", "materials": {"rubber": {"restitution": 1.1}},
    "generate": [{"type": "field", "seed": 7, "balls": 320, "ball": {"radius": 0.1, "mass": 1}, "density": 1.6,
                  "speed": 2, "walls": "rubber",
                  "segments": {"per_ball": 0.1875, "length": [0.5, 1.5]},
                  "bumpers": {"per_ball": 0.125, "radius": [0.2, 0.4], "material": "rubber"}}]})";

double to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const double t = std::clamp(dot(p - a, b - a) / length_squared(b - a), 0.0, 1.0);
    return length(p - (a + t * (b - a)));
}

TEST(Generate, FieldHasWhatItAsksForAndNothingOverlaps) {
    const Scene scene = parse_scene(field_text, "s.json");
    ASSERT_EQ(scene.balls.size(), 320U);
    ASSERT_EQ(scene.parts.size(), 1U + 60 + 40);
    const double side = std::sqrt(320 / 1.6);
    const auto& walls = std::get<shape::Polyline>(scene.parts[0].shape.is);
    EXPECT_TRUE(walls.closed);
    EXPECT_EQ(walls.points[2], (Vec2{side, side}));
    EXPECT_TRUE(scene.bounds.contains({0, 0}) && scene.bounds.contains({side, side}));
    for (const Ball& ball : scene.balls) {
        const auto [x, y] = ball.position;
        EXPECT_GT(std::min({x, y, side - x, side - y}), ball.radius);
        EXPECT_LE(length(ball.velocity), 2);
        for (const Ball& other : scene.balls)
            if (other.number != ball.number) {
                EXPECT_GT(length(other.position - ball.position), 0.2);
            }
        for (const Part& part : scene.parts) {
            if (const auto* circle = std::get_if<shape::Circle>(&part.shape.is)) {
                EXPECT_GT(length(circle->center - ball.position), circle->radius + 0.1);
            }
            if (const auto* segment = std::get_if<shape::Segment>(&part.shape.is)) {
                EXPECT_GT(to_segment(ball.position, segment->a, segment->b), 0.1);
            }
        }
    }
}

TEST(Generate, SameSeedSameFieldOtherSeedOther) {
    const Scene a = parse_scene(field_text, "s.json"), b = parse_scene(field_text, "s.json");
    EXPECT_EQ(a.balls, b.balls);
    std::string other = field_text;
    other.replace(other.find("\"seed\": 7"), 9, "\"seed\": 8");
    EXPECT_NE(parse_scene(other, "s.json").balls[0].position, a.balls[0].position);
}

TEST(Generate, CountOfTheFieldCanBeGivenAnew) {
    const auto file =
        std::filesystem::temp_directory_path() / ("flipside-field-" + std::to_string(getpid()) + ".json");
    std::ofstream(file) << field_text;
    const Scene scene = load_scene(file, 20000);
    EXPECT_EQ(scene.balls.size(), 20000U);
    EXPECT_EQ(scene.parts.size(), 1U + 3750 + 2500);
    const auto& walls = std::get<shape::Polyline>(scene.parts[0].shape.is);
    EXPECT_DOUBLE_EQ(walls.points[2].x * walls.points[2].y, 20000 / 1.6);
    expect_error(error_of([&] { (void)load_scene(file, 0); }),
                 file.string() + ": /generate/0/balls: ", "is 0; allowed: a whole number from 1 to 1000000");
    std::filesystem::remove(file);
    const std::filesystem::path drop = test::source("assets/scenes/drop.json");
    expect_error(error_of([&] { (void)load_scene(drop, 5); }), drop.string() + ": ", "no field is generated");
}

TEST(Generate, RowsOfBallsAndStaggeredPins) {
    const Scene scene = parse_scene(R"({"format": "flipside-scene/1",
        "bounds": {"min": [0, 0], "max": [9, 9]}, "generate": [
        {"type": "rows", "of": "balls", "from": [1, 1], "step": [0.5, 0], "count": 3, "rows": 2,
         "row_step": [0, 1], "radius": 0.1, "mass": 2},
        {"type": "rows", "of": "pins", "from": [1, 5], "step": [1, 0], "count": 2, "rows": 2, "row_step": [0, 1],
         "stagger": true}]})",
                                    "s.json");
    ASSERT_EQ(scene.balls.size(), 6U);
    EXPECT_EQ(scene.balls[5].position, (Vec2{2, 2}));
    EXPECT_EQ(scene.balls[5].number, 5U);
    EXPECT_EQ(scene.balls[5].velocity, Vec2{});
    ASSERT_EQ(scene.parts.size(), 4U);
    EXPECT_EQ(scene.parts[3].name, "pin-4");
    EXPECT_EQ(std::get<shape::Point>(scene.parts[3].shape.is).at, (Vec2{2.5, 6}));
}

}  // namespace
}  // namespace flipside
