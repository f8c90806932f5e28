#include "lab/scenes/scene_notes.hpp"

#include <gtest/gtest.h>

#include "lab/files/assets.hpp"
#include "world/scene_builder.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

Ball ball(BallNumber number, Vec2 position) {
    Ball made;
    made.number = number;
    made.position = position;
    made.radius = 0.1;
    made.mass = 1;
    return made;
}

TEST(SceneNotes, NameBallsThatStartWhereTheyCanNotBe) {
    Scene scene = empty_scene();
    scene.bounds = {{0, 0}, {2, 2}};
    Part block{"block", 0, {shape::Compound{{{shape::Circle{{1, 1}, 0.3}}, {shape::Point{{0.3, 0.3}}}}}}, {}};
    scene.parts.push_back(block);
    scene.balls = {ball(0, {0.5, 0.5}), ball(1, {0.65, 0.5}), ball(2, {1.2, 1}), ball(3, {2.08, 2.08}),
                   ball(4, {2.05, 1})};
    const std::vector<std::string> expected{"ball 1 starts inside ball 0",
                                            "ball 2 starts inside part 'block'",
                                            "ball 3 starts outside the bounds"};
    EXPECT_EQ(notes_on(scene), expected);
}

TEST(SceneNotes, NameLayersThatNothingIsOn) {
    Scene scene = empty_scene();
    scene.bounds = {{0, 0}, {2, 2}};
    scene.layers = {"default", "upper", "lower", "uper"};
    Part ramp{"ramp", 0, {shape::Circle{{1, 1}, 0.3}}, {}};
    ramp.layer = 2;
    ramp.collides_with = 8;
    scene.parts = {ramp};
    scene.balls = {ball(0, {0.5, 0.5})};
    scene.balls[0].layer = 4;
    EXPECT_EQ(notes_on(scene),
              std::vector<std::string>{"nothing is on layer 'uper', which a collides_with names"});
}

TEST(SceneNotes, LeaveOutWhatDoesNotMeet) {
    Scene scene = empty_scene();
    scene.bounds = {{0, 0}, {2, 2}};
    Part sensor{"sensor", 0, {shape::Circle{{1, 1}, 0.3}}, {}};
    sensor.sensor = true;
    Part other{"other", 0, {shape::Circle{{1, 1}, 0.3}}, {}};
    other.layer = 2;
    scene.parts = {sensor, other};
    scene.balls = {ball(0, {1, 1}), ball(1, {1.2, 1})};
    const std::vector<std::string> met{"ball 0 starts inside part 'other'",
                                       "ball 1 starts inside part 'other'"};
    EXPECT_EQ(notes_on(scene), met);
    scene.balls[0].collides_with = 1;
    scene.balls[1].collides_with = 1;
    EXPECT_EQ(notes_on(scene), std::vector<std::string>{});
}

TEST(SceneNotes, TheScenesThatShipHaveNone) {
    for (const std::string& name : scene_names())
        EXPECT_EQ(notes_on(load_scene(scene_file(name))), std::vector<std::string>{}) << name;
}

}  // namespace
}  // namespace flipside::lab
