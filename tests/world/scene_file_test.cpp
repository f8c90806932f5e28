#include "world/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include "places.hpp"
#include "world/json_file.hpp"
#include "world/script_file.hpp"
#include "world/support.hpp"

namespace flipside {
namespace {

const std::filesystem::path scenes = test::source("assets/scenes");
using std::numbers::pi;

/// A scene with one part of this shape.
Shape shape_of(const std::string& json) {
    return parse_scene(R"({"format": "flipside-scene/1", "bounds": {"min": [-9, -9], "max": [9, 9]},
                           "parts": [{"name": "it", "shape": )" +
                           json + "}]}",
                       "s.json")
        .parts.at(0)
        .shape;
}

TEST(SceneFile, DropIsReadAsWritten) {
    const Scene scene = load_scene(scenes / "drop.json");
    EXPECT_EQ(scene.name, "drop");
    EXPECT_EQ(scene.gravity, (Vec2{0, -9.81}));
    EXPECT_EQ(scene.bounds, (Box{{-1, -0.5}, {1, 1.5}}));
    ASSERT_EQ(scene.balls.size(), 1U);
    EXPECT_EQ(scene.balls[0].position, (Vec2{0, 1.0135}));
    ASSERT_EQ(scene.parts.size(), 1U);
    EXPECT_EQ(scene.materials[scene.parts[0].material].restitution, 0.8);
    EXPECT_EQ(std::get<shape::Segment>(scene.parts[0].shape.is).b, (Vec2{0.8, 0}));
}

TEST(SceneFile, EverySceneThatComesWithTheProgramLoadsAndSoDoesTheScriptBesideIt) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
        const std::string file = entry.path().string();
        if (!file.ends_with(".json") || file.ends_with(".script.json")) continue;
        std::string error = error_of([&] { (void)load_scene(file); });
        EXPECT_EQ(error, "no error");
        const std::string script = file.substr(0, file.size() - 5) + ".script.json";
        if (error == "no error" && std::filesystem::exists(script)) {
            error = error_of([&] { (void)load_script(script, load_scene(file)); });
            EXPECT_EQ(error, "no error");
        }
        ++count;
    }
    EXPECT_GE(count, 1);
}

TEST(SceneFile, AFileOfAnotherKindIsRefusedAsSuch) {
    const char* const state = R"({"format": "flipside-state/1", "balls": [{"mass": -1}], "time": 0})";
    expect_error(error_of([&] { (void)parse_scene(state, "s.json"); }),
                 "s.json: /format: ", "is \"flipside-state/1\"; allowed: \"flipside-scene/1\"");
}

TEST(SceneFile, LeastSceneHasTheDefaults) {
    const Scene scene =
        parse_scene(R"({"format": "flipside-scene/1", "bounds": {"min": [0, 0], "max": [1, 1]}})", "s.json");
    EXPECT_TRUE(scene.balls.empty() && scene.parts.empty());
    EXPECT_FALSE(scene.launcher || scene.rules || scene.camera || scene.keep_lost);
    EXPECT_EQ(scene.gravity, Vec2{});
    EXPECT_EQ(scene.damping, 0);
    EXPECT_EQ(scene.rest_speed, 0.01);
    ASSERT_EQ(scene.materials.size(), 1U);
    EXPECT_EQ(scene.materials[0].restitution, 1);
    EXPECT_EQ(scene.materials[0].friction, 0);
    EXPECT_EQ(scene.materials[0].kick, 0);
    EXPECT_EQ(scene.layers, std::vector<std::string>{"default"});
}

TEST(SceneFile, DegreesBecomeRadians) {
    const auto arc = std::get<shape::Arc>(
        shape_of(R"({"type": "arc", "center": [1, 2], "radius": 3, "from_deg": -90, "to_deg": 45})").is);
    EXPECT_DOUBLE_EQ(arc.from, -pi / 2);
    EXPECT_DOUBLE_EQ(arc.to, pi / 4);
    const auto circle = std::get<shape::Arc>(
        shape_of(R"({"type": "arc", "center": [1, 2], "radius": 3, "from_deg": 10, "to_deg": 370})").is);
    EXPECT_DOUBLE_EQ(circle.to, circle.from + 2 * pi);
}

TEST(SceneFile, ClockwisePolygonsAreReversed) {
    const auto points_of = [](const std::string& points) {
        return std::get<shape::Polygon>(shape_of(R"({"type": "polygon", "points": )" + points + "}").is)
            .points;
    };
    const std::vector<Vec2> anticlockwise = {{0, 0}, {1, 0}, {1, 1}};
    EXPECT_EQ(points_of("[[0, 0], [1, 0], [1, 1]]"), anticlockwise);
    EXPECT_EQ(points_of("[[1, 1], [1, 0], [0, 0]]"), anticlockwise);
}

TEST(SceneFile, GateNormalIsTheUnitNormalOnTheSideThatIsMeant) {
    const auto gate = std::get<shape::Gate>(
        shape_of(R"({"type": "gate", "a": [0, 0], "b": [2, 0], "normal": [5, -0.1]})").is);
    EXPECT_EQ(gate.normal, (Vec2{0, -1}));
}

TEST(SceneFile, EveryShapeAndMotionIsRead) {
    const Scene scene = scene_with_everything();
    const auto& flipper = std::get<shape::Flipper>(scene.parts[1].shape.is);
    EXPECT_EQ(flipper.pivot, (Vec2{0.5, 0}));
    EXPECT_DOUBLE_EQ(flipper.rest, -pi / 6);
    const auto& flip = std::get<motion::Flip>(scene.parts[1].motion);
    EXPECT_EQ(flip.side, Side::left);
    EXPECT_DOUBLE_EQ(flip.raised, pi / 6);
    EXPECT_EQ(flip.up_rate, 20);
    EXPECT_EQ(flip.down_rate, 10);
    const auto& turn = std::get<motion::Turn>(scene.parts[2].motion);
    EXPECT_EQ(turn.pivot, (Vec2{0, 0.5}));
    EXPECT_EQ(turn.rate, 3);
    EXPECT_FALSE(turn.always);
    EXPECT_TRUE(scene.parts[4].target);
    EXPECT_EQ(std::get<shape::Point>(shape_of(R"({"type": "point", "at": [1, 2]})").is).at, (Vec2{1, 2}));
    EXPECT_EQ(
        std::get<shape::Capsule>(shape_of(R"({"type": "capsule", "a": [0, 0], "b": [1, 0], "radius": 2})").is)
            .radius,
        2);
    const auto line = std::get<shape::Polyline>(
        shape_of(R"({"type": "polyline", "points": [[0, 0], [1, 0], [0, 1]], "closed": true})").is);
    EXPECT_TRUE(line.closed);
    EXPECT_EQ(line.points.size(), 3U);
    const auto compound =
        std::get<shape::Compound>(shape_of(R"({"type": "compound", "of": [{"type": "point", "at": [1, 2]},
                     {"type": "compound", "of": [{"type": "circle", "center": [0, 0], "radius": 1}]}]})")
                                      .is);
    EXPECT_EQ(std::get<shape::Compound>(compound.of.at(1).is).of.size(), 1U);
}

TEST(SceneFile, LayersAreNumberedAsTheyAreNamed) {
    const Scene scene = parse_scene(R"({"format": "flipside-scene/1",
        "bounds": {"min": [-1, -1], "max": [1, 1]},
        "balls": [{"position": [0, 0], "radius": 0.1, "mass": 1, "layer": "ramp", "collides_with": ["ramp"]}],
        "parts": [{"name": "up", "layer": "ramp", "shape": {"type": "point", "at": [0, 0]}},
                  {"name": "low", "collides_with": ["default", "attic"], "shape": {"type": "point", "at": [0, 0]}}]
        })",
                                    "s.json");
    EXPECT_EQ(scene.layers, (std::vector<std::string>{"default", "ramp", "attic"}));
    EXPECT_EQ(scene.balls[0].layer, 2U);
    EXPECT_EQ(scene.balls[0].collides_with, 2U);
    EXPECT_EQ(scene.parts[0].collides_with, ~0U);
    EXPECT_EQ(scene.parts[1].collides_with, 5U);
    EXPECT_TRUE(layers_meet(scene.balls[0], scene.parts[0]));
    EXPECT_FALSE(layers_meet(scene.balls[0], scene.parts[1]));
}

TEST(SceneFile, LauncherRulesAndRecommendationsAreRead) {
    const Scene scene = parse_scene(R"({"format": "flipside-scene/1",
        "bounds": {"min": [-1, -1], "max": [1, 1]}, "lost": "keep", "camera": {"min": [0, 0], "max": [1, 1]},
        "parts": [{"name": "bumper", "shape": {"type": "circle", "center": [0, 0], "radius": 0.1}},
                  {"name": "lane", "sensor": true, "shape": {"type": "point", "at": [0, 0]}},
                  {"name": "drop", "target": true, "shape": {"type": "point", "at": [0, 0]}}],
        "launcher": {"position": [0.5, -0.5], "direction_deg": 90, "speed": [1, 3], "plunger": true,
                     "ball": {"radius": 0.0135, "mass": 0.08}},
        "rules": {"balls": 5, "ball_save": 8, "tilt": {"nudges": 2, "seconds": 4}, "score": {"bumper": 100},
                  "targets": [{"parts": ["drop"], "bonus": 500}],
                  "lanes": [{"parts": ["lane"], "bonus": 50, "shift": true}],
                  "ball_search": 7, "skill_shot": {"parts": ["lane"], "bonus": 25},
                  "multiball": {"balls": 3, "strength": 0.5, "jackpot": 900},
                  "end_bonus": {"points": {"drop": 20}, "most_times": 4},
                  "spinners": [{"part": "lane", "points": 10, "turns_per_speed": 4}]},
        "recommend": {"custom": {"motion_iterations": 8, "solver": "simple"}, "box2d": {"bullets": true},
                      "run": {"dt": 0.001}}})",
                                    "s.json");
    EXPECT_TRUE(scene.keep_lost);
    EXPECT_EQ(scene.camera, (Box{{0, 0}, {1, 1}}));
    ASSERT_TRUE(scene.launcher && scene.rules);
    EXPECT_NEAR(length(scene.launcher->direction - Vec2{0, 1}), 0, 1e-15);
    EXPECT_EQ(scene.launcher->slowest, 1);
    EXPECT_EQ(scene.launcher->fastest, 3);
    EXPECT_TRUE(scene.launcher->plunger);
    EXPECT_EQ(scene.launcher->ball.radius, 0.0135);
    EXPECT_EQ(scene.rules->balls, 5);
    EXPECT_EQ(scene.rules->ball_save, 8);
    EXPECT_EQ(scene.rules->tilt_nudges, 2);
    EXPECT_EQ(scene.rules->tilt_seconds, 4);
    ASSERT_EQ(scene.rules->scores.size(), 1U);
    EXPECT_EQ(scene.rules->scores[0].part, 0U);
    EXPECT_EQ(scene.rules->scores[0].points, 100);
    EXPECT_EQ(scene.rules->targets.at(0).parts, std::vector<PartIndex>{2});
    EXPECT_EQ(scene.rules->lanes.at(0).bonus, 50);
    EXPECT_TRUE(scene.rules->lanes.at(0).shift);
    EXPECT_FALSE(scene.rules->targets.at(0).shift);
    EXPECT_EQ(scene.rules->ball_search, 7);
    ASSERT_TRUE(scene.rules->skill_shot && scene.rules->multiball && scene.rules->end_bonus);
    EXPECT_EQ(scene.rules->skill_shot->parts, std::vector<PartIndex>{1});
    EXPECT_EQ(scene.rules->skill_shot->bonus, 25);
    EXPECT_EQ(scene.rules->multiball->balls, 3);
    EXPECT_EQ(scene.rules->multiball->strength, 0.5);
    EXPECT_EQ(scene.rules->multiball->jackpot, 900);
    EXPECT_EQ(scene.rules->end_bonus->scores.at(0).part, 2U);
    EXPECT_EQ(scene.rules->end_bonus->scores.at(0).points, 20);
    EXPECT_EQ(scene.rules->end_bonus->most_times, 4);
    EXPECT_EQ(scene.rules->spinners.at(0).turns_per_speed, 4);
    EXPECT_EQ(scene.recommend.at("custom").at("motion_iterations"), "8");
    EXPECT_EQ(scene.recommend.at("custom").at("solver"), "simple");
    EXPECT_EQ(scene.recommend.at("box2d").at("bullets"), "on");
    EXPECT_EQ(scene.recommend.at("run").at("dt"), "0.001");
}

/// A text with a few bytes changed, taken out, doubled or cut off.
std::string damaged(std::string text) {
    const int blows = *rc::gen::inRange(1, 6);
    for (int i = 0; i < blows && !text.empty(); ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        const auto length = *rc::gen::inRange<std::size_t>(1, 20);
        switch (*rc::gen::inRange(0, 4)) {
            case 0:
                text[at] = *rc::gen::arbitrary<char>();
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(at, length));
                break;
            default:
                text[at] = *rc::gen::elementOf(std::string("{}[],:\"-.0123456789e"));
        }
    }
    return text;
}

RC_GTEST_PROP(SceneFile, DamagedTextGivesASceneOrAnInputError, ()) {
    static const std::vector<std::string> texts = [] {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(scenes)) all.push_back(read_file(entry));
        return all;
    }();
    const Scene everything = scene_with_everything();
    for (const std::string& text : texts) {
        const std::string bad = damaged(text);
        // Whatever else is thrown fails the test.
        const std::string error = error_of([&] { (void)parse_scene(bad, "s.json"); });
        RC_ASSERT(error.find('\n') == std::string::npos);
        (void)error_of([&] { (void)parse_script(bad, "s.json", everything); });
    }
}

}  // namespace
}  // namespace flipside
