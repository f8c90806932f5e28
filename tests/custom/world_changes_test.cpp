// States restored into a world of this engine, edited ones too.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "world/state_file.hpp"

namespace flipside::custom::test {
namespace {

/// Three balls in a trough, one of them on the others.
Scene heap() {
    Scene scene = empty_scene({0, -9.81});
    add_part(scene, segment({-1, 0}, {1, 0}));
    for (const double x : {-0.11, 0.11}) add_part(scene, segment({x, 0}, {x, 1}));
    add_part(scene, segment({2, 1}, {3, 1}));
    add_ball(scene, {-0.01, 0.1});
    add_ball(scene, {0.01, 0.1 + std::sqrt(0.04 - 0.0004)});
    add_ball(scene, {2.5, 1.1});
    return scene;
}

State asleep(const Scene& scene) {
    const auto world = make_world(scene);
    run(*world, 5);
    for (const Ball& ball : world->balls()) EXPECT_TRUE(ball.asleep) << ball.number;
    return world->save();
}

TEST(Restore, SleepingBallsStayAsleepToTheBit) {
    const Scene scene = heap();
    const State before = parse_state(to_json(asleep(scene), scene), "file", scene);
    const auto world = make_world(scene);
    world->restore(before);
    EXPECT_EQ(world->save(), before);
    run(*world, 1);
    EXPECT_TRUE(std::ranges::equal(world->balls(), before.balls));
}

TEST(Restore, ASleepingBallInTheAirWakes) {
    const Scene scene = heap();
    State edited = asleep(scene);
    edited.balls[2].position.y = 3;
    edited.balls[1].position.y = 2;
    const auto world = make_world(scene);
    world->restore(edited);
    EXPECT_TRUE(world->balls()[0].asleep);
    EXPECT_FALSE(world->balls()[1].asleep);
    EXPECT_FALSE(world->balls()[2].asleep);
    world->step(0.1);
    EXPECT_NEAR(world->balls()[2].position.y, 3 - 0.5 * 9.81 * 0.01, 1e-12);
}

// Between two walls: smooth ones cannot carry a ball, rough ones may have clamped it.
TEST(Restore, ASleepingBallBesideSmoothWallsWakes) {
    for (const double friction : {0.0, 0.5}) {
        Scene scene = empty_scene({0, -9.81});
        scene.materials[0].friction = friction;
        add_ball(scene, {0, 1});
        for (const double x : {-0.1, 0.1}) add_part(scene, segment({x, 0}, {x, 2}), {"", 1, friction, 0});
        State edited = make_world(scene)->save();
        edited.balls[0].asleep = true;
        const auto world = make_world(scene);
        world->restore(edited);
        EXPECT_EQ(world->balls()[0].asleep, friction > 0) << friction;
    }
}

TEST(Restore, ASleepingBallThatMovesWakes) {
    const Scene scene = heap();
    State edited = asleep(scene);
    edited.balls[2].velocity = {0.1, 0};
    const auto world = make_world(scene);
    world->restore(edited);
    EXPECT_TRUE(world->balls()[0].asleep);
    EXPECT_FALSE(world->balls()[2].asleep);
}

TEST(Restore, WithoutGravityABallSleepsAnywhere) {
    Scene scene = heap();
    scene.gravity = {};
    State edited = make_world(scene)->save();
    for (Ball& ball : edited.balls) ball.asleep = true;
    const auto world = make_world(scene);
    world->restore(edited);
    EXPECT_EQ(world->save(), edited);
}

}  // namespace
}  // namespace flipside::custom::test
