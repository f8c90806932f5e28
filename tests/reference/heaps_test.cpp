// Balls at rest in contact with each other: where they are in equilibrium they stay, else they are refused.

#include <cmath>

#include <gtest/gtest.h>

#include "heap_scenes.hpp"
#include "reference/support.hpp"
#include "world/refusal.hpp"

namespace flipside::reference::test {
namespace {

Scene with_floor(double friction) {
    Scene scene = empty_scene({0, -heap_gravity});
    scene.materials[0].friction = friction;
    add_part(scene, segment({-9, 0}, {9, 0}), {"", 0.5, friction, 0});
    return scene;
}
/// Two balls on a floor and one upon them, all of radius 0.1 m.
Scene pyramid(double friction) {
    Scene scene = with_floor(friction);
    add_ball(scene, {-0.1, 0.1});
    add_ball(scene, {0.1, 0.1});
    add_ball(scene, {0, 0.1 + 0.2 * std::sqrt(0.75)});
    return scene;
}
Scene column(int balls, double gap = 0) {
    Scene scene = with_floor(0);
    for (int i = 0; i < balls; ++i)
        add_ball(scene, {0, 0.1 + (0.2 + gap) * i}, {}, 0.1, i % 2 == 0 ? 1 : 1000);
    return scene;
}

/// Runs for a while; "" where nothing moved, else what was refused.
std::string refusal_of(World& world, double seconds = 2) {
    const std::vector<Ball> before(world.balls().begin(), world.balls().end());
    try {
        run(world, seconds);
    } catch (const Refusal& refusal) {
        return refusal.what();
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_LE(length(world.balls()[i].position - before[i].position), 1e-14) << "ball " << i;
        EXPECT_EQ(world.balls()[i].velocity, Vec2{}) << "ball " << i;
    }
    EXPECT_EQ(world.statistics().impacts, 0U);
    return "";
}
std::string refusal_of(const Scene& scene) {
    return refusal_of(*make_world(scene));
}
void expect_says(const std::string& refusal, const std::string& what) {
    EXPECT_NE(refusal.find(what), std::string::npos) << refusal;
}

TEST(ReferenceHeaps, StayWhereTheyAreInEquilibrium) {
    EXPECT_EQ(refusal_of(column(2)), "");
    EXPECT_EQ(refusal_of(column(10)), "");  // heavy on light
    EXPECT_EQ(refusal_of(pyramid(0.3)), "");
    EXPECT_EQ(refusal_of(heap_in_groove(2, 0)), "");  // a ball on two that rest in a groove
    EXPECT_EQ(refusal_of(heap_in_groove(6, 0)), "");
    EXPECT_EQ(refusal_of(heap_in_groove(6, 0.4)), "");
}

TEST(ReferenceHeaps, StayInBothPrecisionsAndTheTwinAgrees) {
    const auto world = make_world(pyramid(0.3), {{"precision", "113"}, {"twin", "on"}});
    EXPECT_EQ(refusal_of(*world), "");
    for (const double uncertainty : world->uncertainty()) EXPECT_LE(uncertainty, 1e-16);
}

TEST(ReferenceHeaps, ThatMoveAreRefusedAndItSaysWhichBallMovesFirst) {
    expect_says(
        refusal_of(pyramid(0)),
        "are in resting contact at 0.000000 s: resting contact between balls has no order of impacts");
    expect_says(refusal_of(pyramid(0.2)), "begins to move");  // tan 15° is 0.268
    Scene aside = column(3);
    aside.balls[2].position += Vec2{1e-9, 0};
    expect_says(refusal_of(aside), "ball 2 begins to move: 0.000000");
}

TEST(ReferenceHeaps, TouchWithinTheirTolerances) {
    // Gaps to 2e-3 radii and overlaps to 1e-2 are touch; with more of a gap it falls.
    EXPECT_EQ(refusal_of(column(3, 1.9e-4)), "");
    EXPECT_EQ(refusal_of(column(3, -0.9e-3)), "");
    expect_says(refusal_of(column(3, -1.1e-3)), "in resting contact");
    const auto apart = make_world(column(2, 2.1e-4));
    run(*apart, 1.0 / 240, 1.0 / 240);
    EXPECT_LT(apart->balls()[1].position.y, 0.3 + 2.1e-4);
    // On a part, too. A ball that is deeper in one comes out of it, and so into the other ball.
    Scene sunk = column(2);
    for (Ball& ball : sunk.balls) ball.position.y -= 0.9e-3;
    EXPECT_EQ(refusal_of(sunk), "");
    for (Ball& ball : sunk.balls) ball.position.y -= 0.2e-3;
    expect_says(refusal_of(sunk), "in resting contact");
}

TEST(ReferenceHeaps, GoOnFromAState) {
    const Scene scene = heap_in_groove(4, 0.2);
    const auto first = make_world(scene), second = make_world(scene);
    run(*first, 0.5);
    second->restore(first->save());
    EXPECT_EQ(refusal_of(*second), "");
}

TEST(ReferenceHeaps, ThatAreHitAreRefusedByName) {
    Scene scene = column(3);
    add_ball(scene, {-1, 0.3}, {4, 0});
    expect_says(refusal_of(scene), "ball 3 hits ball 0 in a heap of 3 balls");
    Scene turning = column(3);
    Part& bar = add_part(turning, segment({0.5, 0.1}, {0.5, 0.4}));
    bar.name = "bar";
    bar.motion = motion::Turn{{0.3, 0.1}, 2, true};
    expect_says(refusal_of(turning), "bar hits ball 1 in a heap of 3 balls");
}

TEST(ReferenceHeaps, AreLookedAtAgainWhenABallGoes) {
    const auto fewer = make_world(pyramid(0.3));
    run(*fewer, 0.1);
    fewer->remove(2);
    EXPECT_EQ(refusal_of(*fewer), "");  // each of the lower ones stands alone
    const auto alone = make_world(pyramid(0.3));
    run(*alone, 0.1);
    alone->remove(0);
    expect_says(refusal_of(*alone), "in resting contact");
}

TEST(ReferenceHeaps, AreJoinedByABallThatIsLaidOnThem) {
    const auto world = make_world(column(2));
    run(*world, 0.1);
    EXPECT_EQ(world->statistics().asleep, 2U);
    Ball top = world->balls()[0];
    top.position.y = 0.5;
    world->add(top);
    EXPECT_EQ(refusal_of(*world), "");
    EXPECT_EQ(world->statistics().asleep, 3U);
    top.position.y = 0.7 + 1e-2;  // falls on them
    world->add(top);
    expect_says(refusal_of(*world), "ball 3 hits ball 2 in a heap of 3 balls");
}

TEST(ReferenceHeaps, AreLookedAtAgainWhenWhatTheyLieOnMoves) {
    Scene scene = column(3);
    scene.parts.clear();
    Part& plate = add_part(scene, segment({-1, 0}, {1, 0}));
    plate.motion = motion::Turn{{0, 0}, 1, false};
    const auto world = make_world(scene);
    EXPECT_EQ(refusal_of(*world), "");
    world->apply(control::Rotate{true});
    expect_says(refusal_of(*world), "in resting contact");
}

TEST(ReferenceHeaps, NudgesAndLaunchesSetThemInMotion) {
    const auto nudged = make_world(column(2));
    run(*nudged, 0.1);
    nudged->apply(control::Nudge{{0.1, 0}});
    expect_says(refusal_of(*nudged), "in resting contact");
}

TEST(ReferenceHeaps, BallsThatTouchWithoutPressingAreNone) {
    Scene scene = with_floor(0.5);
    for (int i = 0; i < 5; ++i) add_ball(scene, {0.2 * i, 0.1});
    add_ball(scene, {-1, 0.1}, {1, 0});
    scene.rest_speed = 0;
    const auto world = make_world(scene);
    EXPECT_NO_THROW(run(*world, 0.5));  // the row is not hit yet
    EXPECT_EQ(world->balls()[0].velocity, Vec2{});
    try {
        run(*world, 1);
    } catch (const Refusal& refusal) {
        ADD_FAILURE() << refusal.what();
    }
}

TEST(ReferenceHeaps, ABallComesToRestOnAnother) {
    Scene scene = with_floor(0);
    scene.rest_speed = 0.01;
    scene.materials[0].restitution = 0.5;
    add_ball(scene, {0, 0.1});
    add_ball(scene, {0, 0.4});
    const auto world = make_world(scene);
    run(*world, 2);
    EXPECT_NEAR(world->balls()[1].position.y, 0.3, 1e-14);
    EXPECT_EQ(refusal_of(*world), "");
}

}  // namespace
}  // namespace flipside::reference::test
