#include "custom/islands/sleep.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

Ball ball_of(BallNumber number, Vec2 velocity) {
    Ball ball;
    ball.number = number;
    ball.velocity = velocity;
    ball.radius = 0.1;
    return ball;
}

TEST(Sleep, ASlowBallWithoutAccelerationFallsAsleep) {
    Sleep sleep(0.01, {{0, -10}, 0});
    std::vector<Ball> balls{ball_of(0, {0.001, 0}), ball_of(1, {0.02, 0}), ball_of(2, {})};
    sleep.watch(balls, 0.01);
    balls[2].velocity = {0, -0.005};  // at its highest point on a slope
    EXPECT_TRUE(sleep.update(balls, {}));
    EXPECT_TRUE(balls[0].asleep);
    EXPECT_EQ(balls[0].velocity, Vec2{});
    EXPECT_FALSE(balls[1].asleep);
    EXPECT_FALSE(balls[2].asleep);
}

TEST(Sleep, ABallWithoutSupportSleepsOnlyIfItDoesNotMove) {
    Sleep drifting(0.01, {{}, 0});
    std::vector<Ball> balls{ball_of(0, {1e-9, 0}), ball_of(1, {}), ball_of(2, {})};
    balls[2].spin = 1e-9;
    drifting.watch(balls, 0.01);
    drifting.update(balls, {});
    EXPECT_FALSE(balls[0].asleep);
    EXPECT_TRUE(balls[1].asleep);
    EXPECT_FALSE(balls[2].asleep);

    Sleep falling(0.01, {{0, -1e-4}, 0});
    balls = {ball_of(0, {})};
    falling.watch(balls, 0.01);
    balls[0].velocity = {0, -1e-6};
    EXPECT_FALSE(falling.update(balls, {}));
    EXPECT_FALSE(balls[0].asleep);
}

// At its final speed a ball in a viscous medium does not accelerate; one that lies on something does not
// move.
TEST(Sleep, ABallThatSinksSteadilyIsNotAtRest) {
    const double drag = 1e4, sinks = 10 / drag;  // 0.001 m/s
    Sleep sleep(0.01, {{0, -10}, drag});
    std::vector<Ball> balls{ball_of(0, {0, -sinks}), ball_of(1, {})};
    sleep.watch(balls, 0.01);
    balls[0].position.y -= 0.01 * sinks;
    EXPECT_TRUE(sleep.update(balls, {}));
    EXPECT_FALSE(balls[0].asleep);
    EXPECT_TRUE(balls[1].asleep);
}

// A longer interval allows more speed to balls in contact, since gravity gives more in it.
TEST(Sleep, BallsInContactMayMoveAtATwentiethOfTheSpeedOfGravity) {
    for (const double moment : {0.01, 10.0}) {
        Sleep sleep(0.01, {{0, -10}, 0});
        std::vector<Ball> balls{ball_of(0, {1, 0}), ball_of(1, {1, 0})};
        sleep.watch(balls, moment);
        for (Ball& ball : balls) ball.position.x += moment;
        const Contact touching[] = {{0, Other::ball(1), {}, {}, 0}};
        EXPECT_EQ(sleep.update(balls, touching), moment == 10);
    }
}

// A moving ball keeps only the balls awake that it touches.
TEST(Sleep, ABallSleepsBesideBallsAtRest) {
    Sleep sleep(0.01, {{0, -10}, 0});
    std::vector<Ball> balls{ball_of(0, {}), ball_of(1, {}), ball_of(2, {}), ball_of(3, {0.02, 0})};
    balls[0].asleep = true;
    sleep.watch(balls, 0.01);
    const Contact row[] = {
        {0, Other::ball(1), {}, {}, 0}, {1, Other::ball(2), {}, {}, 0}, {2, Other::ball(3), {}, {}, 0}};
    EXPECT_TRUE(sleep.update(balls, row));
    EXPECT_TRUE(balls[1].asleep);
    EXPECT_FALSE(balls[2].asleep);
    EXPECT_FALSE(balls[3].asleep);
}

TEST(Sleep, ABallThatMovesWakesTheSleeperThatItTouches) {
    for (const double speed : {0.03, 0.05}) {  // at rest: 0.01 m/s
        Sleep sleep(0.01, {{0, -10}, 0});
        std::vector<Ball> balls{ball_of(0, {}), ball_of(1, {}), ball_of(2, {speed, 0})};
        balls[0].asleep = balls[1].asleep = true;
        sleep.watch(balls, 0.01);
        const Contact row[] = {{0, Other::ball(1), {}, {}, 0}, {1, Other::ball(2), {}, {}, 0}};
        sleep.update(balls, row);
        EXPECT_TRUE(balls[0].asleep);
        EXPECT_EQ(balls[1].asleep, speed == 0.03);
    }
}

TEST(Sleep, NewBallsAreIgnored) {
    Sleep sleep(0.01, {{0, -10}, 0});
    std::vector<Ball> balls{ball_of(3, {})};
    sleep.watch(balls, 0.01);
    balls = {ball_of(3, {}), ball_of(4, {})};
    sleep.update(balls, {});
    EXPECT_TRUE(balls[0].asleep);
    EXPECT_FALSE(balls[1].asleep);
}

TEST(Sleep, ASqueezedBallStaysAwake) {
    Sleep sleep(0.01, {{0, -10}, 0});
    std::vector<Ball> balls{ball_of(0, {}), ball_of(1, {}), ball_of(2, {})};
    sleep.watch(balls, 0.01);
    const Contact deep{0, Other::ball(2), {}, {}, -0.011 * 0.1},
        shallow{1, Other::part(0), {}, {}, -0.009 * 0.1};
    const Contact contacts[] = {deep, shallow};
    sleep.update(balls, contacts);
    EXPECT_FALSE(balls[0].asleep);
    EXPECT_TRUE(balls[1].asleep);
    EXPECT_FALSE(balls[2].asleep);
}

Scene row_of_balls(int count) {
    Scene scene = empty_scene({0, -9.81});
    for (int i = 0; i < count; ++i) add_ball(scene, {0.3 * i, 0.1});
    add_part(scene, segment({-1, 0}, {0.3 * count + 1, 0}));
    return scene;
}
bool all_asleep(const World& world) {
    return std::ranges::all_of(world.balls(), &Ball::asleep);
}

// A ball at rest that was woken or added falls asleep at the end of the window.
TEST(Sleep, AChangeFromOutsideWakes) {
    Scene scene = empty_scene({});
    add_ball(scene, {0, 0}, {1, 0});
    add_ball(scene, {0, 5}, {0, 1});
    const auto lone = [&] {
        auto world = make_world(scene);
        run(*world, 0.3);
        EXPECT_EQ(std::ranges::count_if(world->balls(), &Ball::asleep), 0);
        return world;
    };
    const auto nudged = lone();
    nudged->apply(control::Nudge{{-1, 0}});
    run(*nudged, 0.3);
    EXPECT_TRUE(nudged->balls()[0].asleep);
    EXPECT_FALSE(nudged->balls()[1].asleep);

    Ball still = scene.balls[0];
    still.position = {3, 0};
    still.velocity = {};
    const auto joined = lone();
    joined->add(still);
    run(*joined, 0.3);
    EXPECT_TRUE(joined->balls()[2].asleep);
    EXPECT_TRUE(joined->remove(0));  // indices have shifted, and all are awake
    EXPECT_FALSE(joined->balls()[1].asleep);
    run(*joined, 0.3);
    EXPECT_TRUE(joined->balls()[1].asleep);
    EXPECT_FALSE(joined->balls()[0].asleep);

    const auto restored = lone();
    State state = restored->save();
    state.balls[1].velocity = {};
    restored->restore(state);
    run(*restored, 0.3);
    EXPECT_FALSE(restored->balls()[0].asleep);
    EXPECT_TRUE(restored->balls()[1].asleep);
}

TEST(Sleep, TableOfAHundredSleepersMakesNoTests) {
    const auto world = make_world(row_of_balls(100));
    run(*world, 0.6);
    ASSERT_TRUE(all_asleep(*world));
    EXPECT_EQ(world->contacts().size(), 100U);
    world->step(1.0 / 60);
    EXPECT_EQ(world->contacts().size(), 100U);
    EXPECT_EQ(world->statistics().pair_tests, 0U);
    EXPECT_EQ(world->statistics().narrow_tests, 0U);
    EXPECT_EQ(world->statistics().asleep, 100U);
}

TEST(Sleep, TheToggleKeepsAllAwake) {
    const auto world = make_world(row_of_balls(3), {{"sleep", "off"}});
    run(*world, 1);
    EXPECT_TRUE(std::ranges::none_of(world->balls(), &Ball::asleep));
}

TEST(Sleep, NudgeWakesAll) {
    const auto world = make_world(row_of_balls(5));
    run(*world, 0.3);
    world->apply(control::Nudge{{0.5, 0}});
    world->step(1.0 / 60);
    EXPECT_TRUE(std::ranges::none_of(world->balls(), &Ball::asleep));
    EXPECT_NEAR(world->balls()[0].velocity.x, 0.5, 1e-12);
}

TEST(Sleep, AHitWakesOnlyTheOneHit) {
    Scene scene = row_of_balls(5);
    const auto world = make_world(scene);
    run(*world, 0.3);
    Ball ball = scene.balls[0];
    ball.position = {-0.5, 0.1};
    ball.velocity = {2, 0};
    world->add(ball);
    run(*world, 0.18);
    EXPECT_FALSE(world->balls()[0].asleep);
    EXPECT_GT(world->balls()[0].velocity.x, 1.9);
    EXPECT_TRUE(world->balls()[4].asleep);
}

TEST(Sleep, ATargetThatGoesDownWakesOnlyWhatLiesOnIt) {
    Scene scene = row_of_balls(5);
    add_ball(scene, {0.9, 1.1}), add_ball(scene, {0.9, 1.3});
    const auto shelf = static_cast<PartIndex>(scene.parts.size());
    add_part(scene, segment({0.4, 1}, {1.4, 1})).target = true;
    const auto world = make_world(scene);
    run(*world, 0.6);
    ASSERT_TRUE(all_asleep(*world));
    Ball ball = scene.balls[0];
    ball.position = {1.3, 0.5};
    ball.velocity = {0, 8};
    world->add(ball);
    run(*world, 0.12);
    ASSERT_TRUE(world->parts()[shelf].down);
    for (const Ball& b : world->balls())
        EXPECT_EQ(b.asleep, b.position.y < 0.2) << b.number << " at " << b.position.y;
    EXPECT_EQ(world->statistics().asleep, 5U);
}

TEST(Sleep, WithoutGravityASlowBallDriftsOn) {
    Scene scene = empty_scene({});
    add_ball(scene, {0, 0}, {1e-5, 0});
    const auto world = make_world(scene);
    run(*world, 1);
    EXPECT_NEAR(world->balls()[0].position.x, 1e-5, 1e-17);
}

TEST(Sleep, AMovingSupportWakes) {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0.5, 0.1});
    add_part(scene, segment({-1, 0}, {1, 0}), {"", 0.1, 0, 0}).motion = motion::Turn{{-1, 0}, 0.5, false};
    const auto world = make_world(scene);
    run(*world, 0.3);
    ASSERT_TRUE(all_asleep(*world));
    world->apply(control::Rotate{true});
    run(*world, 0.18);
    EXPECT_FALSE(world->balls()[0].asleep);
    EXPECT_GT(world->balls()[0].position.y, 0.2);
}

TEST(Sleep, ABallThatTurnsBackOnASlopeDoesNotSleep) {
    Scene scene = empty_scene({0, -1.11});
    const Vec2 up = from_angle(0.05);
    add_ball(scene, 0.1 * perp(up), 0.001 * up);
    add_part(scene, segment(-5 * up, 5 * up));
    const auto world = make_world(scene);
    run(*world, 2);
    EXPECT_FALSE(world->balls()[0].asleep);
    // Frictionless slide from 1 mm/s upwards: s = v·t − ½·g·sin(α)·t².
    EXPECT_NEAR(dot(world->balls()[0].position, up), 0.002 - 2 * 1.11 * std::sin(0.05), 1e-9);
}

}  // namespace
}  // namespace flipside::custom::test
